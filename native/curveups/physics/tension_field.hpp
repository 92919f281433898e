// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxed neo-Hookean membrane: where it would be compressed it wrinkles (A. C. Pipkin, "The
// relaxed energy density for isotropic elastic membranes", IMA J. Appl. Math. 36, 1986; D. J.
// Steigmann, "Tension-field theory", Proc. R. Soc. Lond. A 429, 1990). Per kappa, with l1 >= l2:
//   taut      l1 >= 1, l2 >= l1^-1/2    l1 + l2 + 1 / (l1 l2) - 3
//   wrinkled  l1 >= 1, l2 <  l1^-1/2    l1 + 2 l1^-1/2 - 3     (uniaxial tension)
//   slack     l1 < 1                    0
// Convex and once continuously differentiable in F.
#pragma once

#include "curveups/physics/density.hpp"

namespace curveups {

// Adds regularization |F|^2 so that slack parts have a unique position and the Hessian is positive
// definite everywhere.
Density tension_field(const Gradient32& F, double regularization, bool second);

}  // namespace curveups
