// SPDX-License-Identifier: LGPL-2.1-or-later
// The one value that is computed, saved and passed on.
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
  std::optional<TriangleMesh> target;  // where the mesh has moved away from it
};

// All that follows from mesh, cuts and thicknesses alone.
struct DesignGeometry {
  TileMesh tiles;
  Truncation truncation;
  std::vector<ContactPatch> patches;
  PinBounds pin_bounds;
  bool shaped = true;  // else tiles have no back face, and there are no planes and patches
};

// Throws what make_tile_mesh throws, InvalidInput where held_tiles names none of them, and
// InfeasibleDesign with the tiles where folds leave them no
// back face. Pairs in truncation.unresolved are left to the caller (report them, or refuse).
DesignGeometry make_geometry(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters);

// The same of tiles that have back faces.
DesignGeometry make_geometry(TileMesh tiles, const Parameters& parameters);

// Area of the layout, mm2: tiles, quadrilaterals of contacts, polygons at uncut interior vertices.
double flat_area(const DesignGeometry& geometry, const FlatCorners& corners);

}  // namespace curveups
