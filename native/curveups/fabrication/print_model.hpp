// SPDX-License-Identifier: LGPL-2.1-or-later
// Everything that is printed, in print coordinates: front side up, the back pins' feet at z = 0,
// the back faces at H_pin, the front faces at H_pin + H_body, the pin tops at 2 H_pin + H_body, or
// all of that turned over about the x axis (orientation front-down); the box of all bodies centred
// on the z axis.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "curveups/bodies/joint_holes.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/bodies/tile_bodies.hpp"
#include "curveups/geometry/convex_polygon.hpp"

class TopoDS_Shape;  // of OpenCASCADE: whole only where it is used

namespace curveups {

// Solids by kind, made when they are first asked for, by whichever thread comes first.
struct KeptSolids {
  std::recursive_timed_mutex building;
  std::map<std::string, std::shared_ptr<const TopoDS_Shape>> by_kind;
};

// The narrowest place of a body, mm, and what it is.
struct ThinFeature {
  std::string body, what;
  double size;
  int tile = -1;  // PrintBody::tile
};

// How a print is divided among beds: along gaps between tiles, and within what a bed has room for.
struct Division {
  std::vector<int> part_of_tile;  // by rows of F; empty: pieces are not divided
  double opening = 0;             // mm between slabs of two parts
  Polygon
      region;  // of the layout's plane, convex: anchors beyond it go, slabs end at it; empty: all
};

struct PrintModel : TileBodies {
  std::string name;
  int piece_count = 0;
  std::vector<int> piece_of_tile;
  std::vector<RigidMotion> flat;    // tile frame to print coordinates
  std::vector<PrintBody> tiles;     // in print coordinates, T00001 first
  std::vector<PrintBody> supports;  // "Support P1" (slabs) or "Support P1 B0001" (bridges)
  std::vector<PrintBody> anchors;   // "Anchor P1 A001"
  // The tiles in the target shape, without bumps and recesses, so that walls meet: world
  // coordinates.
  std::vector<PrintBody> actuated;
  // What no support holds: breakaway, what is not joined to the rest of its piece; soluble, pieces
  // whose bodies run into one another, so that no slab fills the gaps between them.
  std::vector<int> loose_tiles;
  int loose_anchors = 0;
  JointHoles joints;  // through `tiles` and `actuated`
  Division division;
  std::vector<std::vector<Polygon>> outlines;  // of each slab, in print coordinates, by supports
  // Per tile how far, mm, its body reaches out level beyond the pin that it stands on.
  std::vector<double> overhang;
  std::vector<ThinFeature> thin;  // per body that has a size of its own, the narrowest place
  Box box;

  std::shared_ptr<KeptSolids> solids = std::make_shared<KeptSolids>();  // see print_solids.hpp

  // The bodies of a kind: "tiles", "support", "anchors", "print" (these three) or "actuated". Any
  // other throws InvalidInput.
  std::vector<const PrintBody*> bodies(const std::string& kind) const;
  // mm3, by the bodies' own formulas.
  double volume(const std::string& kind) const;
};

// What lies in the plane of the pin tops on one side, mm2: what glue on that side can take.
struct GluedAreas {
  double pins = 0, anchors = 0, support = 0;
};
GluedAreas glued_areas(const PrintModel& model, Side side);

// Throws what make_tile_bodies throws; InfeasibleDesign where pieces are too near to each other for
// their anchors and slabs, or the layout is wider than 10 m; SolverFailure where a slab's outline
// falls apart.
// division: bodies then have their part for their piece, anchors that of the tile that is nearest.
PrintModel make_print_model(const Design& design, const Division& division = {});

// These tiles (rows of F) alone, at their places, each once and in the order of the rows.
PrintModel only_tiles(const PrintModel& model, const std::vector<int>& rows);

// These pieces (or parts) alone, each once, moved within the plane.
PrintModel only_pieces(const PrintModel& model, const std::map<int, RigidMotion>& motions);

// The same with the actuated tiles moved, one motion a tile.
PrintModel move_actuated(const PrintModel& model, const std::vector<RigidMotion>& motions);

}  // namespace curveups
