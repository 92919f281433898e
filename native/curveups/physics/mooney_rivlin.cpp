// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxed Mooney-Rivlin membrane (M. Mooney, "A theory of large elastic deformation", J. Appl.
// Phys. 11, 1940; relaxation: wrinkling.hpp). With kappa = C1 + C2 and s = C2 / kappa,
//   psi / kappa = (1 - s) (I1 - 3) + s (I2 - 3),
//   N = |F|^2 = l1 + l2,  D = |f1 x f2|^2 = l1 l2,  I1 = N + 1 / D,  I2 = D + N / D,
// a function of N and D, whose derivatives by F need no eigen-decomposition. Uniaxial tension is
//   u(l1) = (1 - s) (l1 + 2 l1^-1/2 - 3) + s (2 l1^1/2 + 1 / l1 - 3).
// Convex in F where it wrinkles. Where it is taut, D is not: two large stretches of about equal
// size make the Hessian indefinite (equal ones beyond a stretch near ((1 - s) / s)^1/2).
#include <Eigen/Geometry>
#include <cmath>

#include "curveups/physics/wrinkling.hpp"

namespace curveups {
namespace {

Density taut(const Gradient32& F, double s, bool second) {
  using Eigen::Vector3d;
  const Vector3d f1 = F.col(0), f2 = F.col(1), n = f1.cross(f2);
  const double N = F.squaredNorm(), r = 1 / n.squaredNorm();  // 1 / D
  Vector6 f, a;                                               // half the gradients of N and of D
  f << f1, f2;
  a << f2.cross(n), n.cross(f1);
  const double by_N = (1 - s) + s * r, by_D = s - (1 - s) * r * r - s * N * r * r;
  Density out;
  out.value = (1 - s) * (N + r - 3) + s * (1 / r + N * r - 3);
  out.gradient = 2 * (by_N * f + by_D * a);
  if (!second) return out;
  const Matrix6 bend = cross_curvature(F);  // half the Hessian of D
  const double by_ND = -s * r * r, by_DD = 2 * r * r * r * ((1 - s) + s * N);
  out.hessian = 2 * by_N * Matrix6::Identity() + 2 * by_D * bend +
                4 * by_ND * (f * a.transpose() + a * f.transpose()) + 4 * by_DD * a * a.transpose();
  return out;
}

}  // namespace

Density mooney_rivlin(const Gradient32& F, const DensityConstants& constants, bool second) {
  const double s = constants.mooney_share;
  return relaxed(
      F, constants.regularization, second, [&] { return taut(F, s, second); },
      [s](double l1) {
        const double root = std::sqrt(l1), r = 1 / l1, rr = r / root;  // l1^-3/2
        return UniaxialTension{
            (1 - s) * (l1 + 2 / root - 3) + s * (2 * root + r - 3),
            (1 - s) * (1 - rr) + s * (1 / root - r * r),
            (1 - s) * 1.5 * rr * r + s * (2 * r * r * r - 0.5 * rr),
        };
      });
}

}  // namespace curveups
