// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/given_forces.hpp"

#include "curveups/core/parallel.hpp"

namespace curveups {

double PointLoads::value(const Poses& poses) const {
  double sum = 0;
  for (const PointLoad& load : loads) sum -= load.force.dot(poses[load.body](load.point));
  return sum;
}

double PointLoads::derivatives(const Poses& poses, double lever, Motions& gradient,
                               BlockMatrix<6>* hessian, int) const {
  double sum = 0;
  for (const PointLoad& load : loads) {
    const RigidMotion& pose = poses[load.body];
    const Vec3 arm = pose.R * load.point;
    MotionDerivatives<1> out;
    out.gradient << -load.force, arm.cross(-load.force) / lever;
    if (!convex) {
      out.hessian.bottomRightCorner<3, 3>() = turn_curvature(-load.force, arm, lever);
    }
    out.add_to({load.body}, gradient, hessian, 0);
    sum -= load.force.dot(arm + pose.t);
  }
  return sum;
}

void PairLoads::couple(std::vector<Coupling>& couplings) const {
  for (const PairLoad& load : loads) couplings.push_back({load.body[0], load.body[1]});
}

double PairLoads::value(const Poses& poses) const {
  return parallel_sum(static_cast<int>(loads.size()), [&](int k) {
    const PairLoad& load = loads[k];
    return -load.force.dot(seen_from(poses[load.body[0]], poses[load.body[1]], load.point));
  });
}

double PairLoads::derivatives(const Poses& poses, double lever, Motions& gradient,
                              BlockMatrix<6>* hessian, int first) const {
  double sum = 0;
  parallel_gather<MotionDerivatives<2>>(
      static_cast<int>(loads.size()),
      [&](int k, MotionDerivatives<2>& out) {
        const PairLoad& load = loads[k];
        out = {};
        out.value =
            -load.force.dot(seen_from(poses[load.body[0]], poses[load.body[1]], load.point));
        add_seen_point(poses, load.body, 1, 0, load.point, -load.force, Eigen::Matrix3d::Zero(),
                       lever, hessian != nullptr && !convex, convex, out);
      },
      [&](int k, const MotionDerivatives<2>& out) {
        sum += out.value;
        out.add_to(loads[k].body, gradient, hessian, first + k);
      });
  return sum;
}

}  // namespace curveups
