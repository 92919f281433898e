// SPDX-License-Identifier: LGPL-2.1-or-later
// Everything that is printed, in print coordinates. Front side up: the back pins' feet at z = 0,
// the back faces at H_pin, the front faces at H_pin + H_body, the pin tops at 2 H_pin + H_body;
// with orientation front-down all of that turned over about the x axis. The box of all bodies is
// centred on the z axis.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "curveups/bodies/joint_holes.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/bodies/tile_print.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// Narrowest place of a body, mm.
struct ThinFeature {
  std::string body, what;
  double size;
  int tile = -1;  // PrintBody::tile
};

// Division of a print among beds: along gaps between tiles, and at the edges of a bed.
struct Division {
  std::vector<int> part_of_tile;  // per row of F; empty: pieces are not divided
  double opening = 0;             // mm between slabs of two parts
  Polygon region;  // convex, in the layout's plane: anchors beyond are left out, slabs end there
};

struct PrintModel : TileBodies {
  std::string name;
  int piece_count = 0;
  std::vector<int> piece_of_tile;
  std::vector<RigidMotion> flat;    // tile frame to print coordinates
  std::vector<PrintBody> tiles;     // T00001 first
  std::vector<PrintBody> supports;  // "Support P1" (slabs) or "Support P1 B0001" (bridges)
  std::vector<PrintBody> anchors;   // "Anchor P1 A001"
  // Tiles in the target shape, in world coordinates, without bumps and recesses: walls meet.
  std::vector<PrintBody> actuated;
  // Bodies without support. Breakaway: not joined to the rest of their piece. Soluble: in a piece
  // whose bodies run into one another, so that no slab fills the gaps between them.
  std::vector<int> loose_tiles;
  int loose_anchors = 0;
  JointHoles joints;  // through `tiles` and `actuated`
  Division division;
  std::vector<std::vector<Polygon>> outlines;  // per slab, in print coordinates
  std::vector<double> overhang;   // per tile: level reach beyond the pin that it stands on, mm
  std::vector<ThinFeature> thin;  // per body with sizes of its own
  Eigen::AlignedBox3d box;

  // Bodies of a kind: "tiles", "support", "anchors", "print" (these three) or "actuated". Throws
  // InvalidInput for any other.
  std::vector<const PrintBody*> bodies(const std::string& kind) const;
  double volume(const std::string& kind) const;  // mm3
};

// Areas in the plane of the pin tops on one side, where glue holds, mm2.
struct GluedAreas {
  double pins = 0, anchors = 0, support = 0;
};
GluedAreas glued_areas(const PrintModel& model, Side side);

// Formats a body's name, such as "Anchor P%d A%03d".
std::string numbered(const char* format, int a, int b = 0);

// With a division, bodies have their part for their piece; anchors have the part of the nearest
// tile. Throws what make_tile_bodies throws; InvalidInput for a division that is none;
// InfeasibleDesign where pieces are too near to each other for their anchors and slabs, or the
// layout is wider than 10 m; SolverFailure where a slab's outline falls apart.
PrintModel make_print_model(const Design& design, const Division& division = {});

// Keeps these tiles (rows of F) alone, each once and in the order of the rows.
PrintModel only_tiles(const PrintModel& model, const std::vector<int>& rows);

// Keeps these pieces (or parts) alone, moved within the plane.
PrintModel only_pieces(const PrintModel& model, const std::map<int, RigidMotion>& motions);

// Moves the actuated tiles, one motion a tile.
PrintModel move_actuated(const PrintModel& model, const std::vector<RigidMotion>& motions);

}  // namespace curveups
