// SPDX-License-Identifier: LGPL-2.1-or-later
// Free parts of one membrane (paper, Fig. 9): between the pins of tiles in contact, and around the
// uncut interior vertices that those contacts enclose. The pins themselves are holes: membrane that
// is glued to a pin balances itself. Holes of the target and slits of cuts stay open.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/design/contacts.hpp"
#include "curveups/design/flat_layout.hpp"

namespace curveups {

// Pin corner c of tile i has the number 3 i + c.
inline int pin_corner_index(int tile, int corner) { return 3 * tile + corner; }

// A polygon of membrane. Its sides are, for a quadrilateral, pin edge, free side, pin edge, free
// side; for a vertex polygon, the free sides of the quadrilaterals around it.
struct MembranePatch {
  std::vector<int> corners;  // pin corner numbers, counter-clockwise in the flat plane
  int contact;               // the contact bridged, or -1
  int vertex;                // the mesh vertex enclosed, or -1
};

struct MembraneDomain {
  Side side;
  int tile_count;
  std::vector<MembranePatch> patches;  // contacts in their order, then vertices
};

MembraneDomain make_membrane_domain(const TileMesh& tiles, Side side);

// Tiles (from 0) whose corners a patch uses, each once, in ascending order.
std::vector<int> tiles_of(const MembranePatch& patch);

// Positions of all pin tops' corners, 3 M rows: flat in the layout's plane, actuated in space. The
// flat ones throw InfeasibleDesign, naming the tiles, where insets leave a pin no area.
Points2 flat_pin_corners(const TileMesh& tiles, const FlatPoses& poses, const Array6& q, Side side);
Points3 actuated_pin_corners(const TileMesh& tiles, const Array6& q, Side side, double H_pin);

// z of the pins' tops in every tile's frame.
double pin_top_level(const TileMesh& tiles, Side side, double H_pin);

}  // namespace curveups
