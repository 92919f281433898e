// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies as OpenCASCADE solids, built face by face with shared edges: no sewing, no booleans.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// A solid of one closed shell. Caps and cylinders are true spheres and cylinders. Throws
// SolverFailure, as all of this header, where OpenCASCADE fails.
TopoDS_Shape make_solid(const PrintBody& body);

// One per body, in parallel. Throws Cancelled.
std::vector<TopoDS_Shape> make_solids(const std::vector<const PrintBody*>& bodies);

TopoDS_Shape make_compound(const std::vector<TopoDS_Shape>& shapes);

}  // namespace curveups
