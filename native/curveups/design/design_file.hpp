// SPDX-License-Identifier: LGPL-2.1-or-later
// design.json: format "curveups-design", version 1.
#pragma once

#include <string>

#include "curveups/design/design.hpp"

namespace curveups {

// The text of the file; numbers in the fewest digits that read back to the same double.
std::string write_design(const Design& design);

// Throws InvalidInput naming the field: not JSON, wrong format or version, missing field, an
// unknown or out-of-range parameter, arrays that do not fit one another (design_arrays.hpp).
Design read_design(const std::string& text);

}  // namespace curveups
