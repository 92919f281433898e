// SPDX-License-Identifier: LGPL-2.1-or-later
// Fairing of a surface to feasibility: the least movement of its vertices (clearance_program.hpp)
// for which every tile has a back face and room for its pins on both sides. Folds, thickness,
// insets and truncation planes bound that room: a fold is too sharp where it leaves a tile none. It
// comes before the smoothing for pins and has wider limits: where folds leave tiles no back face
// there is no design yet.
#pragma once

#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

struct SmoothedTarget {
  TriangleMesh mesh;  // the given one, bit for bit, where there was nothing to do or nothing helped
  std::vector<double> move;         // mm, per vertex
  std::vector<SmallPin> fixed;      // sides that had too little room, with their area before
  std::vector<SmallPin> remaining;  // sides that have too little now, with their area
  // Pairs of tiles that no plane parts; unknown while tiles have no back face.
  std::vector<std::array<int, 2>> overlapping;
  int steps = 0;
};

// No vertex moves farther than `largest_move` (mm); those of `kept` (vertex pairs) and those far
// from tiles without room stay. Those of the boundary stay, too, unless tiles then remain without
// room. Faired again, the result stays as it is unless sides remain. Throws what make_tile_mesh
// throws, InvalidInput (largest_move negative or not finite), Cancelled.
SmoothedTarget smooth_target(const TriangleMesh& mesh, const Edges& cuts, const Edges& kept,
                             double largest_move, const Parameters& parameters,
                             const Progress& progress);

}  // namespace curveups
