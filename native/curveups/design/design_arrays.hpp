// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that the arrays of a design fit one another before anything is computed from them.
#pragma once

#include <optional>
#include <string>

#include "curveups/design/design.hpp"

namespace curveups {

struct ArrayFault {
  std::string field;  // e.g. "T"[7], with the quotation marks
  std::string why;    // e.g. is not counter-clockwise
};

// The first of: no tiles; a number that is not finite; a vertex that there is not; T or q without a
// row per tile; edges that are no tiles' of L (their mean is not within a factor of 4, as where
// coordinates have another unit than L); a flat tile that is not congruent to its actuated one
// (1e-3 mm) or not counter-clockwise.
std::optional<ArrayFault> find_array_fault(const Design& design);

// Throws InvalidInput where there is one.
void require_fitting_arrays(const Design& design);

}  // namespace curveups
