// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/wrinkling.hpp"

namespace curveups {

// With g1 = F n1, g2 = F n2 (orthogonal) and dF = (d1, d2) in the same basis: d l1 = 2 g1 . d1 and
// d2 l1 = 2 |d1|^2 + 2 (g2 . d1 + g1 . d2)^2 / (l1 - l2).
Density wrinkled_density(const Gradient32& F, const PrincipalStretches& l, const UniaxialTension& u,
                         bool second) {
  Density out;
  out.value = u.value;
  const Eigen::Vector2d n1 = principal_direction(F);
  const double c = n1.x(), s = n1.y();
  const Eigen::Vector3d g1 = F * n1;
  out.gradient << 2 * u.slope * c * g1, 2 * u.slope * s * g1;
  if (!second) return out;
  const Eigen::Vector3d g2 = F * Eigen::Vector2d(-s, c);
  // d1 = c df1 + s df2, d2 = -s df1 + c df2.
  Eigen::Matrix<double, 6, 3> along;
  along << c * Eigen::Matrix3d::Identity(), s * Eigen::Matrix3d::Identity();
  Vector6 first, shear;
  first << c * g1, s * g1;
  shear << c * g2 - s * g1, s * g2 + c * g1;
  // The slope vanishes as l1 - l2 does, at l1 = 1.
  const double turn = u.slope > 0 ? 2 * u.slope / (l.l1 - l.l2) : 0.0;
  out.hessian = 4 * u.curvature * first * first.transpose() +
                2 * u.slope * along * along.transpose() + turn * shear * shear.transpose();
  return out;
}

}  // namespace curveups
