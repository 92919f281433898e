// SPDX-License-Identifier: LGPL-2.1-or-later
// design.json: format "curveups-design", version 1, and the checks of its arrays.
#pragma once

#include <string>

#include "curveups/design/design.hpp"

namespace curveups {

// Throws InvalidInput, naming the entry, where there are no tiles; for a number that is not finite;
// for a vertex that does not exist; where T or q lack a row per tile; for edges far from L (their
// mean is not within a factor of 4, as where coordinates have another unit than L); for a flat tile
// that is not congruent to its actuated one (1e-3 mm) or not counter-clockwise.
void require_fitting_arrays(const Design& design);

// The text of the file; numbers in the fewest digits that read back to the same double.
std::string write_design(const Design& design);

// Throws InvalidInput naming the field: not JSON, wrong format or version, missing field, an
// unknown or out-of-range parameter, or as
// require_fitting_arrays.
Design read_design(const std::string& text);

}  // namespace curveups
