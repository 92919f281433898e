// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/loads.hpp"

#include <algorithm>

namespace curveups {
namespace {

constexpr double standard_gravity = 9.80665;  // m / s2

}  // namespace

GravityLoad gravity_load(const DesignGeometry& geometry, const Parameters& parameters) {
  const TileMesh& tiles = geometry.tiles;
  const int count = tiles.tile_count();
  GravityLoad load;
  load.weight = Wrenches::Zero(count, 6);
  if (parameters.gravity == "off") return load;
  const Vec3 down =
      Vec3(parameters.gravity_x, parameters.gravity_y, parameters.gravity_z).normalized();
  const Points3 centres = tile_centres(tiles);
  std::vector<std::vector<Vec3>> corners(count);
  double lowest = -1e300;
  for (int i = 0; i < count; ++i) {
    const ConvexBody body = tile_body(tiles, geometry.truncation, i);
    // g / cm3 = 1e-6 kg / mm3.
    const Vec3 force = down * (parameters.density * 1e-6 * volume(body) * standard_gravity);
    const Vec3 arm = tiles.frame[i].to_world(centroid(body)) - centres.row(i).transpose();
    load.weight.row(i) << force.transpose(), arm.cross(force).transpose();
    for (const Vec3& p : body.points) {
      corners[i].push_back(tiles.frame[i].to_world(p));
      lowest = std::max(lowest, down.dot(corners[i].back()));
    }
  }
  if (parameters.gravity == "resting") {
    for (int i = 0; i < count; ++i) {
      for (const Vec3& p : corners[i]) {
        if (down.dot(p) > lowest - parameters.L / 20)
          load.ground.push_back({p, -down, {-1, i}, -1});
      }
    }
    return load;
  }
  load.held = listed_tiles(parameters.held_tiles);
  if (load.held.empty()) {
    std::vector<char> joined(tiles.topology.edges.size(), 0);
    for (const Contact& contact : tiles.contacts) joined[contact.edge] = 1;
    const std::vector<int> piece = face_components(tiles.topology, joined);
    const int pieces = count > 0 ? *std::max_element(piece.begin(), piece.end()) + 1 : 0;
    std::vector<int> lowest_tile(pieces, -1);
    for (int i = 0; i < count; ++i) {
      int& best = lowest_tile[piece[i]];
      if (best < 0 || down.dot(centres.row(i)) > down.dot(centres.row(best))) best = i;
    }
    load.held = lowest_tile;
  }
  std::sort(load.held.begin(), load.held.end());
  return load;
}

}  // namespace curveups
