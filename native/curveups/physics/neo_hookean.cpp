// SPDX-License-Identifier: LGPL-2.1-or-later
// Incompressible neo-Hookean membrane (paper, Eqs. 17 to 19):
//   psi / kappa = l1 + l2 + 1 / (l1 l2) - 3 = |F|^2 + 1 / |f1 x f2|^2 - 3,
// without an eigen-decomposition. An element without area has infinite energy. The Hessian is
// indefinite where the membrane is compressed.
#include <Eigen/Geometry>

#include "curveups/physics/density.hpp"

namespace curveups {
namespace {

// Half the Hessian of |f1 x f2|^2 by F.
Matrix6 cross_curvature(const Gradient32& F) {
  using Eigen::Matrix3d;
  const Eigen::Vector3d f1 = F.col(0), f2 = F.col(1);
  const Matrix3d off =
      2 * f1 * f2.transpose() - f2 * f1.transpose() - f1.dot(f2) * Matrix3d::Identity();
  Matrix6 out;
  out.topLeftCorner<3, 3>() = f2.squaredNorm() * Matrix3d::Identity() - f2 * f2.transpose();
  out.bottomRightCorner<3, 3>() = f1.squaredNorm() * Matrix3d::Identity() - f1 * f1.transpose();
  out.topRightCorner<3, 3>() = off;
  out.bottomLeftCorner<3, 3>() = off.transpose();
  return out;
}

}  // namespace

Density neo_hookean(const Gradient32& F, double /*regularization*/, bool second) {
  const Eigen::Vector3d f1 = F.col(0), f2 = F.col(1), n = f1.cross(f2);
  // As |f1 x f2|^2: the difference form of det C goes negative by cancellation.
  const double s = 1 / n.squaredNorm();
  Vector6 a;  // gradient of |n|^2 / 2
  a << f2.cross(n), n.cross(f1);
  Density out;
  const double norm = F.squaredNorm();
  out.value = norm + s - 3;
  out.gradient << f1, f2;
  out.gradient = 2 * (out.gradient - s * s * a);
  if (!second) return out;
  out.hessian = 2 * Matrix6::Identity() + (8 * s * s * s) * a * a.transpose() -
                (2 * s * s) * cross_curvature(F);
  return out;
}

}  // namespace curveups
