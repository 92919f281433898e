// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP (AP214) with a named, coloured solid per body. Written straight from the bodies: through
// OpenCASCADE's writer 2500 tiles took 16 s and 0.8 GB and lost digits; this takes a second and
// nothing.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// An assembly of all bodies, each a product of its own, in mm; no two of them have one name.
// Products have their bodies' names and ids that no other body or file of the design has: `title`,
// and for parts of it "title/name". The same bodies give the same bytes: no dates. Throws IoError,
// Cancelled, SolverFailure for a coordinate that is not finite.
void write_step(const std::vector<const PrintBody*>& bodies, const std::string& title,
                const std::string& path);

}  // namespace curveups
