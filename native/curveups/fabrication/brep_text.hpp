// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary representations as text that every OpenCASCADE reads, and so FreeCAD's Part.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// Solid of a body: one closed shell, faces with shared edges and vertices, spheres and cylinders
// for caps and cylinder walls. Numbers read back the same. Throws SolverFailure for a coordinate
// that is not finite.
std::string brep_text(const PrintBody& body);

// Solids of all bodies, made in parallel.
std::vector<std::string> brep_texts(const std::vector<const PrintBody*>& bodies);

}  // namespace curveups
