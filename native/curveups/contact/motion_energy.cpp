// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/motion_energy.hpp"

namespace curveups {

Eigen::Matrix<double, 3, 6> point_jacobian(const RigidMotion& pose, const Vec3& p, double lever) {
  Eigen::Matrix<double, 3, 6> out;
  out << Eigen::Matrix3d::Identity(), skew(pose.R * p) / -lever;
  return out;
}

Eigen::Matrix3d turn_curvature(const Vec3& force, const Vec3& arm, double lever) {
  // R p becomes arm + w x arm + w x (w x arm) / 2.
  const Eigen::Matrix3d product = force * arm.transpose();
  return (0.5 * (product + product.transpose()) - force.dot(arm) * Eigen::Matrix3d::Identity()) /
         (lever * lever);
}

Eigen::Matrix3d positive_turn_curvature(const Vec3& force, const Vec3& arm, double lever) {
  const double length = force.norm() * arm.norm();
  if (length == 0) return Eigen::Matrix3d::Zero();
  // With the unit vectors f and a, and c the cosine of their angle, the eigenvalues over the
  // product of both lengths are (1 - c) / 2 along a + f, -(1 + c) / 2 along a - f, and -c across.
  const Vec3 f = force.normalized(), a = arm.normalized(), sum = a + f, difference = a - f;
  const double c = a.dot(f), scale = length / (lever * lever);
  if (c >= 0) return scale * (1 - c) / (4 * (1 + c)) * sum * sum.transpose();
  return scale *
         (0.25 * sum * sum.transpose() + c / (2 * (1 - c)) * difference * difference.transpose() -
          c * Eigen::Matrix3d::Identity());
}

Vec3 seen_from(const RigidMotion& b, const RigidMotion& a, const Vec3& p) { return b.to_own(a(p)); }

void add_seen_point(const Poses& poses, const std::array<int, 2>& bodies, int a, int b,
                    const Vec3& p, const Vec3& by_y, const Eigen::Matrix3d& by_y_twice,
                    double lever, const MotionHessian* hessian, MotionDerivatives<2>& out) {
  const RigidMotion &of_a = poses[bodies[a]], &of_b = poses[bodies[b]];
  const Vec3 arm = of_a.R * p, r = arm + of_a.t - of_b.t, force = of_b.R * by_y;
  const int ta = 6 * a, tb = 6 * b, ra = ta + 3, rb = tb + 3;
  out.gradient.segment<3>(ta) += force;
  out.gradient.segment<3>(ra) += arm.cross(force) / lever;
  out.gradient.segment<3>(tb) -= force;
  out.gradient.segment<3>(rb) -= r.cross(force) / lever;
  if (!hessian) return;

  // y in world axes moves by J m; b's turns move it backwards.
  Eigen::Matrix<double, 3, 12> J;
  const Eigen::Matrix3d by_turn_a = skew(arm) / -lever, by_turn_b = skew(r) / lever;
  J.middleCols<3>(ta) = Eigen::Matrix3d::Identity();
  J.middleCols<3>(ra) = by_turn_a;
  J.middleCols<3>(tb) = -Eigen::Matrix3d::Identity();
  J.middleCols<3>(rb) = by_turn_b;
  const Eigen::Matrix3d H = of_b.R * by_y_twice * of_b.R.transpose();
  const Eigen::Matrix<double, 3, 12> HJ = H * J;
  out.hessian.noalias() += J.transpose() * HJ;
  if (hessian->projected) return;
  // The force times the second-order motion of y: by turns of a, of b, and of both.
  out.hessian.block<3, 3>(ra, ra) += turn_curvature(force, arm, lever);
  out.hessian.block<3, 3>(rb, rb) += turn_curvature(force, r, lever);
  const Eigen::Matrix3d F = skew(force) / lever;
  const Eigen::Matrix3d turned = F * by_turn_a;
  out.hessian.block<3, 3>(rb, ta) += F;
  out.hessian.block<3, 3>(ta, rb) -= F;
  out.hessian.block<3, 3>(rb, tb) -= F;
  out.hessian.block<3, 3>(tb, rb) += F;
  out.hessian.block<3, 3>(rb, ra) += turned;
  out.hessian.block<3, 3>(ra, rb) += turned.transpose();
}

}  // namespace curveups
