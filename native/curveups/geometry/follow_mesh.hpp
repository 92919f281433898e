// SPDX-License-Identifier: LGPL-2.1-or-later
// Carries a tiling along when its surface changes, so that tiles keep their numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct FollowOptions {
  double L = 7.0;           // mean edge length, mm
  double crease_angle = 4;  // rad, as in RemeshOptions
  // Creases of the surface, vertex pairs; none: its edges that bend by more than crease_angle.
  std::optional<Edges> features = std::nullopt;
};

struct FollowedMesh {
  // Why the surface needs a new tiling; empty: the mesh follows.
  std::string obstacle;
  TriangleMesh mesh;
  std::vector<int> tile_from;    // per tile the old tile of the same vertices, -1: new
  std::vector<int> vertex_from;  // per vertex its old number, -1: new
  double mean_edge = 0, edge_cv = 0, chord_error = 0;  // as in RemeshResult
};

// Maps borders and creases of the tiling onto the surface's (follow_lines.hpp), the other vertices
// by a harmonic displacement and then to nearest points along a smoothed one. Springs relax edges
// near those that became much longer or shorter; what is too long then is split, what is too short
// collapsed. Tiles and vertices that stay keep their numbers. New ones take those of removed ones
// and then follow; where more are removed, the last fill the gaps.
// Obstacles: "parts", "borders", "corners", "creases", "edges" (another mean edge than L), "far"
// (parts of the surface would have no tiles), "folded" (tiles would be turned over), "many" (too
// many new tiles). Deterministic. Throws what build_topology and boundary_loops throw, InvalidInput
// (L not positive), SolverFailure, Cancelled.
FollowedMesh follow_mesh(const TriangleMesh& tiles, const TriangleMesh& surface,
                         const FollowOptions& options);

}  // namespace curveups
