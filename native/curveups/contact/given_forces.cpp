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
                               const MotionHessian* hessian) const {
  double sum = 0;
  for (const PointLoad& load : loads) {
    const RigidMotion& pose = poses[load.body];
    const Vec3 arm = pose.R * load.point;
    MotionDerivatives<1> out;
    out.gradient << -load.force, arm.cross(-load.force) / lever;
    if (hessian && !hessian->projected) {
      out.hessian.bottomRightCorner<3, 3>() = turn_curvature(-load.force, arm, lever);
    }
    out.add_to({load.body}, gradient, hessian, 0);
    sum -= load.force.dot(arm + pose.t);
  }
  return sum;
}

std::vector<int> PairLoads::pairs() const {
  std::vector<int> first;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    if (k == 0 || loads[k].body != loads[k - 1].body) first.push_back(static_cast<int>(k));
  }
  first.push_back(static_cast<int>(loads.size()));
  return first;
}

void PairLoads::couple(std::vector<Coupling>& couplings) const {
  const std::vector<int> first = pairs();
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    couplings.push_back({loads[first[k]].body[0], loads[first[k]].body[1]});
  }
}

double PairLoads::value(const Poses& poses) const {
  return parallel_sum(static_cast<int>(loads.size()), [&](int k) {
    const PairLoad& load = loads[k];
    return -load.force.dot(seen_from(poses[load.body[0]], poses[load.body[1]], load.point));
  });
}

// Energy -sum f . (r + a) of a pair and its derivatives, with forces f that turn with body 0, arms
// a that turn with body 1, and r from origin to origin. These need sum f and G = sum f a^T alone.
MotionDerivatives<2> PairLoads::of_pair(int begin, int end, const Poses& poses, double lever,
                                        bool second) const {
  const RigidMotion &one = poses[loads[begin].body[0]], &other = poses[loads[begin].body[1]];
  Vec3 force = Vec3::Zero();
  Eigen::Matrix3d G = Eigen::Matrix3d::Zero();
  for (int k = begin; k < end; ++k) {
    force += loads[k].force;
    G += loads[k].force * loads[k].point.transpose();
  }
  force = one.R * force;
  G = one.R * G * other.R.transpose();
  const Vec3 r = other.t - one.t;
  const Vec3 torque = twice_axial_vector(G);  // sum a x f
  MotionDerivatives<2> out;
  out.value = -force.dot(r) - G.trace();
  out.gradient << force, (torque + r.cross(force)) / lever, -force, -torque / lever;
  if (!second) return out;
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d turns =
      (G.trace() * identity - 0.5 * (G + G.transpose())) / (lever * lever);
  const Eigen::Matrix3d moves = skew(force) / lever;
  out.hessian.block<3, 3>(3, 3) = turns - turn_curvature(force, r, lever);
  out.hessian.block<3, 3>(9, 9) = turns;
  out.hessian.block<3, 3>(3, 9) = (G.transpose() - G.trace() * identity) / (lever * lever);
  out.hessian.block<3, 3>(9, 3) = out.hessian.block<3, 3>(3, 9).transpose();
  out.hessian.block<3, 3>(3, 0) = moves;
  out.hessian.block<3, 3>(3, 6) = -moves;
  out.hessian.block<3, 3>(0, 3) = -moves;
  out.hessian.block<3, 3>(6, 3) = moves;
  return out;
}

double PairLoads::derivatives(const Poses& poses, double lever, Motions& gradient,
                              const MotionHessian* hessian) const {
  const std::vector<int> pair = pairs();
  double sum = 0;
  parallel_gather<MotionDerivatives<2>>(
      static_cast<int>(pair.size()) - 1,
      [&](int k, MotionDerivatives<2>& out) {
        out = of_pair(pair[k], pair[k + 1], poses, lever, hessian && !hessian->projected);
      },
      [&](int k, const MotionDerivatives<2>& out) {
        sum += out.value;
        out.add_to(loads[pair[k]].body, gradient, hessian, k);
      });
  return sum;
}

}  // namespace curveups
