// SPDX-License-Identifier: LGPL-2.1-or-later
// STL and 3MF.
#pragma once

#include <string>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/fabrication/body_mesh.hpp"

namespace curveups {

// Binary STL of all bodies; the header names the title and the unit. Throws IoError.
void write_stl(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path);

// 3MF in mm, one named object with its colour per body (lib3mf). The same meshes give the same
// bytes. Throws IoError, SolverFailure where lib3mf refuses a mesh, Cancelled.
void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path, const Progress& progress);

}  // namespace curveups
