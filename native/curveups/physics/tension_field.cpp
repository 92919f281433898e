// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxed neo-Hookean membrane: where it would be compressed it wrinkles (A. C. Pipkin, "The
// relaxed energy density for isotropic elastic membranes", IMA J. Appl. Math. 36, 1986; D. J.
// Steigmann, "Tension-field theory", Proc. R. Soc. Lond. A 429, 1990). Per kappa, with l1 >= l2:
//   taut      l1 >= 1, l2 >= l1^-1/2    the plain density
//   wrinkled  l1 >= 1, l2 <  l1^-1/2    uniaxial tension, u(l1) = l1 + 2 l1^-1/2 - 3
//   slack     l1 < 1                    0
// Convex and once continuously differentiable in F. Adds regularization |F|^2, so that slack parts
// have a unique position: the Hessian is positive definite.
#include <cmath>

#include "curveups/physics/density.hpp"

namespace curveups {
namespace {

// u(l1) as a function of F. With g1 = F n1, g2 = F n2 (orthogonal) and dF = (d1, d2) in the same
// basis: d l1 = 2 g1 . d1 and d2 l1 = 2 |d1|^2 + 2 (g2 . d1 + g1 . d2)^2 / (l1 - l2).
Density wrinkled(const Gradient32& F, const PrincipalStretches& l, bool second) {
  const double root = std::sqrt(l.l1), slope = 1 - 1 / (l.l1 * root),
               curvature = 1.5 / (l.l1 * l.l1 * root);
  Density out;
  out.value = l.l1 + 2 / root - 3;
  const Eigen::Vector2d n1 = principal_direction(F);
  const double c = n1.x(), s = n1.y();
  const Eigen::Vector3d g1 = F * n1;
  out.gradient << 2 * slope * c * g1, 2 * slope * s * g1;
  if (!second) return out;
  const Eigen::Vector3d g2 = F * Eigen::Vector2d(-s, c);
  // d1 = c df1 + s df2, d2 = -s df1 + c df2.
  Eigen::Matrix<double, 6, 3> along;
  along << c * Eigen::Matrix3d::Identity(), s * Eigen::Matrix3d::Identity();
  Vector6 first, shear;
  first << c * g1, s * g1;
  shear << c * g2 - s * g1, s * g2 + c * g1;
  // The slope vanishes as l1 - l2 does, at l1 = 1.
  const double turn = slope > 0 ? 2 * slope / (l.l1 - l.l2) : 0.0;
  out.hessian = 4 * curvature * first * first.transpose() + 2 * slope * along * along.transpose() +
                turn * shear * shear.transpose();
  return out;
}

}  // namespace

Density tension_field(const Gradient32& F, double regularization, bool second) {
  const PrincipalStretches l = principal_stretches(F);
  Density out;
  if (l.tension() == MembraneTension::taut) out = neo_hookean(F, regularization, second);
  if (l.tension() == MembraneTension::wrinkled) out = wrinkled(F, l, second);
  out.value += regularization * F.squaredNorm();
  out.gradient.head<3>() += 2 * regularization * F.col(0);
  out.gradient.tail<3>() += 2 * regularization * F.col(1);
  if (second) out.hessian.diagonal().array() += 2 * regularization;
  return out;
}

}  // namespace curveups
