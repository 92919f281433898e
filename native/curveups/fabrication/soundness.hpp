// SPDX-License-Identifier: LGPL-2.1-or-later
// Says why solids are unfit for print.
#pragma once

#include <string>
#include <vector>

#include "curveups/core/finding.hpp"

namespace curveups {

// Why a solid is unsound: BRepCheck, an open shell, or a volume that differs from the analytic one
// by more than 1e-9 of it.
struct UnsoundSolid {
  std::string body, reason;
  int tile = -1;  // PrintBody::tile
};

// Why the solids make a design not valid; none where they are sound. How they stand to one another
// is known without them (bodies/body_reasons.hpp).
std::vector<Finding> solid_reasons(const std::vector<UnsoundSolid>& unsound);

}  // namespace curveups
