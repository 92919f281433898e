// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxed neo-Hookean membrane (wrinkling.hpp). Per kappa, uniaxial tension is
//   u(l1) = l1 + 2 l1^-1/2 - 3.
// Convex in F everywhere; with the regularization its Hessian is positive definite.
#include <cmath>

#include "curveups/physics/wrinkling.hpp"

namespace curveups {

Density tension_field(const Gradient32& F, const DensityConstants& constants, bool second) {
  return relaxed(
      F, constants.regularization, second, [&] { return neo_hookean(F, constants, second); },
      [](double l1) {
        const double root = std::sqrt(l1);
        return UniaxialTension{l1 + 2 / root - 3, 1 - 1 / (l1 * root), 1.5 / (l1 * l1 * root)};
      });
}

}  // namespace curveups
