// SPDX-License-Identifier: LGPL-2.1-or-later
// STL, 3MF and STEP of bodies. Files are put together in memory and written at once; the same
// bodies give the same bytes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/fabrication/body_mesh.hpp"

namespace curveups {

// Throws IoError naming the path and the system's reason, and removes an incomplete file.
void write_bytes(const std::string& path, const std::string& bytes);

// Writes a binary STL of all bodies; the header names the title and the unit. Throws IoError.
void write_stl(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path);

// Writes 3MF in mm (lib3mf). Each piece is one build item, an assembly whose components are one
// named object with its material per body: slicers place build items anew, and components keep
// their places. materials: names by BodyKind; a slicer's user gives each its own filament or
// nozzle. Throws IoError, Cancelled, SolverFailure where lib3mf refuses a mesh.
void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::array<std::string, 3>& materials, const std::string& path);

// Writes an AP214 assembly of all bodies in mm, each a named, coloured product. Names of bodies
// differ. Products' ids are unique among the files of a design: `title`, and "title/name" for
// parts. Written without OpenCASCADE, whose writer takes 16 s and 0.8 GB for 2500 tiles and rounds
// coordinates. Throws IoError, Cancelled, SolverFailure for a coordinate that is not finite.
void write_step(const std::vector<const PrintBody*>& bodies, const std::string& title,
                const std::string& path);

}  // namespace curveups
