// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_domain.hpp"

#include <set>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/design/flat_rim.hpp"
#include "curveups/design/pins.hpp"

namespace curveups {

MembraneDomain make_membrane_domain(const TileMesh& tiles, Side side) {
  MembraneDomain domain;
  domain.side = side;
  domain.tile_count = tiles.tile_count();
  domain.patches.reserve(tiles.contacts.size() + tiles.mesh.V.rows());
  for (std::size_t k = 0; k < tiles.contacts.size(); ++k) {
    const Contact& contact = tiles.contacts[k];
    const int i = contact.tile[0], t = contact.side[0], j = contact.tile[1], u = contact.side[1];
    domain.patches.push_back({{pin_corner_index(i, next3(t)), pin_corner_index(i, t),
                               pin_corner_index(j, next3(u)), pin_corner_index(j, u)},
                              static_cast<int>(k),
                              -1});
  }
  std::vector<std::vector<int>> around = corners_around_inner_vertices(tiles);
  for (int v = 0; v < tiles.mesh.V.rows(); ++v) {
    if (!around[v].empty()) domain.patches.push_back({std::move(around[v]), -1, v});
  }
  return domain;
}

std::vector<int> tiles_of(const MembranePatch& patch) {
  std::set<int> tiles;
  for (int corner : patch.corners) tiles.insert(corner / 3);
  return {tiles.begin(), tiles.end()};
}

Points2 flat_pin_corners(const TileMesh& tiles, const FlatPoses& poses, const Array6& q,
                         Side side) {
  std::vector<int> bad;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if (!(pin_area(tiles, i, side, q.row(i).data()) > 0)) bad.push_back(i);
  }
  if (!bad.empty()) {
    throw InfeasibleDesign(
        "the " + std::string(side_name(side)) + " pins of " + tile_names(bad) + " have no area",
        "lower their insets", bad);
  }
  Points2 out(3 * tiles.tile_count(), 2);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const std::array<Vec2, 3> placed =
        place(poses, i, pin_corners(tiles, i, side, q.row(i).data()));
    for (int t = 0; t < 3; ++t) out.row(pin_corner_index(i, t)) = placed[t].transpose();
  }
  return out;
}

double pin_top_level(const TileMesh& tiles, Side side, double H_pin) {
  return side == Side::front ? H_pin : -tiles.H_body - H_pin;
}

Points3 actuated_pin_corners(const TileMesh& tiles, const Array6& q, Side side, double H_pin) {
  Points3 out(3 * tiles.tile_count(), 3);
  const double z = pin_top_level(tiles, side, H_pin);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const std::array<Vec2, 3> local = pin_corners(tiles, i, side, q.row(i).data());
    for (int t = 0; t < 3; ++t) {
      out.row(pin_corner_index(i, t)) = tiles.frame[i]({local[t].x(), local[t].y(), z}).transpose();
    }
  }
  return out;
}

}  // namespace curveups
