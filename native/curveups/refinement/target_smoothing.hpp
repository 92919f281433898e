// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface faired to feasibility: the least movement of its vertices (clearance_program.hpp) for
// which every tile has a back face and room for its pins on both sides. Folds, thickness, insets
// and truncation planes meet in that room: a fold is too sharp where it leaves a tile none. The
// same closed forms as in the smoothing for pins, without its narrow limits, and before it: where
// folds leave tiles no back face there is no design yet.
#pragma once

#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

struct SmoothedTarget {
  TriangleMesh mesh;  // the given one, bit for bit, where nothing was to be done or nothing helped
  std::vector<double> move;         // of each vertex, mm
  std::vector<SmallPin> fixed;      // sides that had too little room, with what they had
  std::vector<SmallPin> remaining;  // those that have too little now, with what they have
  std::vector<std::array<int, 2>> overlapping;  // pairs of tiles that no plane parts; not looked
                                                // for while tiles have no back face
  int steps = 0;                                // that were tried
};

// No vertex moves farther than `largest_move` (mm); those of `kept` (vertex pairs) stay. Those of
// the boundary stay, too, unless tiles then remain without room. Vertices
// that nothing asks for stay. Deterministic; faired again, the result stays as it is unless sides
// remain. Throws what make_tile_mesh throws, InvalidInput (a kept edge names no vertex,
// largest_move negative or not finite), Cancelled.
SmoothedTarget smooth_target(const TriangleMesh& mesh, const Edges& cuts, const Edges& kept,
                             double largest_move, const Parameters& parameters,
                             const Progress& progress);

}  // namespace curveups
