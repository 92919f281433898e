// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies as STEP's boundary representation.
#pragma once

#include "curveups/bodies/print_body.hpp"
#include "curveups/fabrication/step_text.hpp"

namespace curveups {

// Adds the body's faces with shared edges and vertices; returns its manifold_solid_brep. Caps and
// cylinders are true spherical and cylindrical surfaces, each with the seam that kernels with
// periodic surfaces expect.
StepId add_step_solid(StepText& step, const PrintBody& body);

}  // namespace curveups
