// SPDX-License-Identifier: LGPL-2.1-or-later
// Incompressible neo-Hookean membrane (paper, Eqs. 17 to 19):
//   psi / kappa = l1 + l2 + 1 / (l1 l2) - 3 = |F|^2 + 1 / |f1 x f2|^2 - 3.
#pragma once

#include "curveups/physics/density.hpp"

namespace curveups {

// Value, gradient and (where `second`) Hessian by F, without an eigen-decomposition. An element
// without area has infinite energy. The Hessian is indefinite where the membrane is compressed.
Density neo_hookean(const Gradient32& F, bool second);

}  // namespace curveups
