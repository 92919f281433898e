// SPDX-License-Identifier: LGPL-2.1-or-later
// The tiles of a design as bodies with bumps: what both physics and fabrication start from.
#pragma once

#include "curveups/bodies/bumps.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

struct TileBodies {
  Parameters parameters;
  DesignGeometry geometry;
  FlatPoses poses;
  Array6 q;
  BumpPlan bumps;
};

// Throws InfeasibleDesign, naming tiles, where pins or faces are turned inside out; what
// make_geometry throws.
TileBodies make_tile_bodies(const Design& design);

}  // namespace curveups
