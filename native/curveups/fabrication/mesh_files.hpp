// SPDX-License-Identifier: LGPL-2.1-or-later
// STL and 3MF.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/fabrication/body_mesh.hpp"

namespace curveups {

// Binary STL of all bodies; the header names the title and the unit. Throws IoError.
void write_stl(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path);

// 3MF in mm (lib3mf): each piece is one build item, an assembly whose components are one named
// object with its material per body. Slicers place every build item anew; components keep their
// places. materials: their names by BodyKind; a slicer's user gives each its
// own filament or nozzle. The same meshes give the same bytes. Throws IoError, SolverFailure
// where lib3mf refuses a mesh, Cancelled.
void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::array<std::string, 3>& materials, const std::string& path);

}  // namespace curveups
