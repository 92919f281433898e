// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/drag.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/parallel.hpp"

namespace curveups {

Drag::Drag(const std::vector<Pair>& pairs, const Poses& from, double lever, double lone)
    : from_(from), lever_(lever), lone_(lone) {
  joints_.reserve(pairs.size());
  for (const Pair& pair : pairs) {
    const RigidMotion &a = from[pair.body[0]], &b = from[pair.body[1]];
    const Vec3 half = 0.5 * (b.t - a.t);
    joints_.push_back(
        {pair, {a.R.transpose() * half, b.R.transpose() * -half}, a.R.transpose() * b.R});
  }
}

Vec3 Drag::gap(const Joint& joint, const Poses& poses) {
  const auto& [a, b] = joint.pair.body;
  return poses[a](joint.point[0]) - poses[b](joint.point[1]);
}

// A turn by an angle counts as the chord that a point moves by at the lever's end.
double Drag::squares(const Joint& joint, const Poses& poses) const {
  const auto& [a, b] = joint.pair.body;
  const double trace = (poses[a].R.transpose() * poses[b].R).cwiseProduct(joint.turn).sum();
  return gap(joint, poses).squaredNorm() + lever_ * lever_ * std::max(0.0, 3 - trace);
}

double Drag::furthest_apart(const Poses& poses) const {
  double most = 0;
  for (const Joint& joint : joints_) most = std::max(most, squares(joint, poses));
  return std::sqrt(most);
}

double Drag::furthest_apart(const Poses& poses, const Motions& motions) const {
  double most = 0;
  for (const Joint& joint : joints_) {
    const auto& [a, b] = joint.pair.body;
    const Vec3 of_a = motions.row(a).tail<3>(), of_b = motions.row(b).tail<3>();
    const Vec3 apart =
        (motions.row(a) - motions.row(b)).head<3>().transpose() +
        (of_a.cross(poses[a].R * joint.point[0]) - of_b.cross(poses[b].R * joint.point[1])) /
            lever_;
    most = std::max(most, apart.squaredNorm() + (of_a - of_b).squaredNorm());
  }
  return std::sqrt(most);
}

double Drag::value(const Poses& poses, double weight) const {
  const double pairs = parallel_sum(static_cast<int>(joints_.size()),
                                    [&](int k) { return squares(joints_[k], poses); });
  return 0.5 * weight * (pairs + lone_ * motions_between(from_, poses, lever_).squaredNorm());
}

double Drag::derivatives(const Poses& poses, double weight, Motions& gradient,
                         const MotionHessian* hessian) const {
  const Motions motions = motions_between(from_, poses, lever_);
  gradient += weight * lone_ * motions;
  double sum = lone_ * motions.squaredNorm();
  parallel_gather<MotionDerivatives<2>>(
      static_cast<int>(joints_.size()),
      [&](int k, MotionDerivatives<2>& out) {
        const Joint& joint = joints_[k];
        const auto& [a, b] = joint.pair.body;
        const Eigen::Matrix3d turn = poses[b].R * joint.turn.transpose() * poses[a].R.transpose();
        Eigen::Matrix<double, 3, 12> J;
        J << point_jacobian(poses[a], joint.point[0], lever_),
            -point_jacobian(poses[b], joint.point[1], lever_);
        out.value = squares(joint, poses);
        out.gradient = weight * J.transpose() * gap(joint, poses);
        // Gradient of the square of the chord by turns of the first body.
        const Vec3 turned = -0.5 * weight * lever_ * twice_axial_vector(turn);
        out.gradient.segment<3>(3) += turned;
        out.gradient.segment<3>(9) -= turned;
        if (!hessian) return;
        out.hessian = weight * J.transpose() * J;
        for (int r = 3; r < 6; ++r) {
          out.hessian(r, r) += weight;
          out.hessian(r + 6, r + 6) += weight;
          out.hessian(r, r + 6) -= weight;
          out.hessian(r + 6, r) -= weight;
        }
      },
      [&](int k, const MotionDerivatives<2>& out) {
        sum += out.value;
        out.add_to(joints_[k].pair.body, gradient, hessian, joints_[k].pair.coupling);
      });
  return 0.5 * weight * sum;
}

}  // namespace curveups
