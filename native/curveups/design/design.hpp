// SPDX-License-Identifier: LGPL-2.1-or-later
// A design: the value that is computed, saved and passed on.
#pragma once

#include <optional>
#include <string>

#include "curveups/design/contacts.hpp"
#include "curveups/design/flat_layout.hpp"
#include "curveups/design/parameters.hpp"
#include "curveups/design/pin_bounds.hpp"

namespace curveups {

struct Design {
  std::string name;
  Parameters parameters;
  TriangleMesh mesh;                   // actuated front vertices and tiles
  FlatCorners T;                       // M x 6 flat front corners
  Array6 q;                            // M x 6 pin insets
  Edges cuts;                          // C x 2 vertex pairs
  std::optional<TriangleMesh> target;  // given where the mesh has moved away from it
};

// Geometry of the tiles, from mesh, cuts and thicknesses alone.
struct DesignGeometry {
  TileMesh tiles;
  Truncation truncation;
  std::vector<ContactPatch> patches;
  PinBounds pin_bounds;
  bool shaped = true;  // false: tiles lack back faces, and there are no planes and patches
};

// Throws what make_tile_mesh throws, InvalidInput where held_tiles names other tiles, and
// InfeasibleDesign with the tiles without a back face. The caller reports or refuses
// truncation.unresolved.
DesignGeometry make_geometry(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters);

// Geometry of tiles that have back faces.
DesignGeometry make_geometry(TileMesh tiles, const Parameters& parameters);

// Area of the layout, mm2: tiles, quadrilaterals of contacts, polygons at uncut interior vertices.
double flat_area(const DesignGeometry& geometry, const FlatCorners& corners);

}  // namespace curveups
