// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/joints.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/design/print_constants.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {

std::vector<Joint> find_joints(const TileMesh& tiles) {
  const std::vector<int> piece = pieces_of_faces(tiles.topology, tiles.cut);
  std::vector<Joint> joints;
  for (std::size_t e = 0; e < tiles.topology.edges.size(); ++e) {
    const MeshEdge& edge = tiles.topology.edges[e];
    if (edge.boundary() || piece[edge.face[0]] == piece[edge.face[1]]) continue;
    joints.push_back(
        {static_cast<int>(e), {edge.face[0], edge.face[1]}, {edge.side[0], edge.side[1]}});
  }
  return joints;
}

double joint_depth(const TileMesh& tiles, const Parameters& p, int tile, int t) {
  return std::max(0.0, tiles.back_shift(tile, t)) + 0.5 * joint_hole +
         p.p_floor / std::cos(0.5 * tiles.dihedral(tile, t));
}

double joint_inset(const TileMesh& tiles, const Parameters& p, int tile, Side side, int t) {
  const double edge = side == Side::back ? tiles.back_shift(tile, t) : 0.0;
  return joint_depth(tiles, p, tile, t) + 0.5 * joint_hole + p.p_floor - edge;
}

Array6 joint_insets(const TileMesh& tiles, const Parameters& p) {
  constexpr double rounding = 1e-3;  // mm, of a layout, which must not close a hole
  Array6 insets = Array6::Zero(tiles.tile_count(), 6);
  if (p.joint != "holes") return insets;
  for (const Joint& joint : find_joints(tiles)) {
    for (int s = 0; s < 2; ++s) {
      const int tile = joint.tile[s], t = joint.side[s];
      for (Side side : {Side::front, Side::back}) {
        insets(tile, inset_index(side, t)) = joint_inset(tiles, p, tile, side, t) + rounding;
      }
    }
  }
  return insets;
}

}  // namespace curveups
