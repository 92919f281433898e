// SPDX-License-Identifier: LGPL-2.1-or-later
// Tiles of a design with bumps, where both physics and fabrication start, and as printed: recessed
// walls, both pins, bumps or hollows in one closed body.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/bodies/bumps.hpp"
#include "curveups/bodies/print_body.hpp"
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

// Makes a tile in its frame: front face at z = 0, pins from 0 to H_pin and below -H_body.
// Precondition: check_pins.
PrintBody make_tile_print(const TileMesh& tiles, const ConvexBody& body,
                          const std::vector<WallCap>& caps, const double* q, int tile,
                          double H_pin);

// Throws InfeasibleDesign, naming the tiles, where insets turn a pin over or push one beyond the
// front or back face of its (recessed, truncated) body.
void check_pins(const TileMesh& tiles, const std::vector<ConvexBody>& bodies, const Array6& q);

// Narrowest places of a tile, mm.
struct TileFeatures {
  double front_pin, back_pin;  // diameter of the outline's inscribed circle
  double body;                 // thickness, or the width of the narrower face
  double bump;                 // diameter, 0 without bumps
  double hollow_wall;          // material beside hollows, infinite without hollows
};
TileFeatures tile_features(const TileMesh& tiles, const ConvexBody& body,
                           const std::vector<WallCap>& caps, const double* q, int tile);

}  // namespace curveups
