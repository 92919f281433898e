// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that solids are sound enough for print files.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/fabrication/soundness.hpp"

namespace curveups {

// Those that are unsound (UnsoundSolid), in the order of the bodies. Throws Cancelled, and
// SolverFailure where OpenCASCADE fails.
std::vector<UnsoundSolid> check_solids(const std::vector<const PrintBody*>& bodies,
                                       const std::vector<TopoDS_Shape>& solids);

}  // namespace curveups
