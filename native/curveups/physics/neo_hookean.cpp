// SPDX-License-Identifier: LGPL-2.1-or-later
// Incompressible neo-Hookean membrane (paper, Eqs. 17 to 19):
//   psi / kappa = l1 + l2 + 1 / (l1 l2) - 3 = |F|^2 + 1 / |f1 x f2|^2 - 3,
// without an eigen-decomposition. An element without area has infinite energy. The Hessian is
// indefinite where the membrane is compressed.
#include <Eigen/Geometry>
#include <cmath>

#include "curveups/physics/density.hpp"

namespace curveups {

Density neo_hookean(const Gradient32& F, const DensityConstants& /*constants*/, bool second) {
  using Eigen::Vector3d;
  const Vector3d f1 = F.col(0), f2 = F.col(1), n = f1.cross(f2);
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
  const Matrix6 bend = cross_curvature(F);
  out.hessian = 2 * Matrix6::Identity() + (8 * s * s * s) * a * a.transpose() - (2 * s * s) * bend;
  return out;
}

}  // namespace curveups
