// SPDX-License-Identifier: LGPL-2.1-or-later
// STL and 3MF.
#pragma once

#include <string>
#include <vector>

#include "curveups/fabrication/body_mesh.hpp"

namespace curveups {

// Binary STL of all bodies; the header names the title and the unit. Throws IoError.
void write_stl(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path);

// What bodies are printed of: names of the 3MF's materials by kind. A slicer's user gives each its
// own filament or nozzle.
struct PrintMaterials {
  std::string tile = "tile", support = "support", anchor = "anchor";
};

// 3MF in mm (lib3mf): each piece is one build item, an assembly whose components are one named
// object with its material per body. Slicers place every build item anew; components keep their
// places. A thumbnail shows all. The same meshes give the same bytes. Throws IoError, SolverFailure
// where lib3mf refuses a mesh, Cancelled.
void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const PrintMaterials& materials, const std::string& path);

}  // namespace curveups
