// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of a body's boundary, from its corners and circles alone: microseconds a body, so that all
// bodies of a print are checked.
#pragma once

#include <string>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// Returns why a body is unsound, or nothing for a sound one. Sound: corners lie in the planes of
// their faces to within tolerance::snap; boundaries of a face neither cross nor touch, holes lie
// inside the outer boundary; every edge belongs to two faces, in opposite directions, and every
// circle to a face and to a cap or cylinder that fits to it; the volume is positive. Intersections
// of two faces away from their edges are not looked for.
std::string unsoundness(const PrintBody& body);

}  // namespace curveups
