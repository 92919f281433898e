// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/flat_layout.hpp"

#include <cmath>

#include "curveups/core/errors.hpp"

namespace curveups {

PlaneRotation::PlaneRotation(double angle) : c(std::cos(angle)), s(std::sin(angle)) {}

std::array<Vec2, 3> place(const FlatPoses& poses, int tile, const std::array<Vec2, 3>& local) {
  const PlaneRotation turn(poses(tile, 2));
  const Vec2 origin(poses(tile, 0), poses(tile, 1));
  return {origin + turn * local[0], origin + turn * local[1], origin + turn * local[2]};
}

void require_row_per_tile(const Array6& values, int tile_count, const std::string& name) {
  if (values.rows() != tile_count) {
    throw InvalidInput(name + " has " + std::to_string(values.rows()) + " rows, there are " +
                           std::to_string(tile_count) + " tiles",
                       "pass one row per tile");
  }
  for (int i = 0; i < tile_count; ++i) {
    if (values.row(i).allFinite()) continue;
    throw InvalidInput(name + " holds a number that is not finite", "pass finite numbers", {i});
  }
}

FlatCorners flat_corners(const TileMesh& tiles, const FlatPoses& poses) {
  FlatCorners corners(tiles.tile_count(), 6);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const std::array<Vec2, 3> placed = place(poses, i, tiles.front[i]);
    for (int t = 0; t < 3; ++t) corners.row(i).segment<2>(2 * t) = placed[t].transpose();
  }
  return corners;
}

FlatPoses fit_poses(const TileMesh& tiles, const FlatCorners& corners) {
  FlatPoses poses(tiles.tile_count(), 3);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const std::array<Vec2, 3>& local = tiles.front[i];
    const Vec2 middle = (local[0] + local[1] + local[2]) / 3;
    Vec2 placed = Vec2::Zero();
    for (int t = 0; t < 3; ++t) placed += corners.row(i).segment<2>(2 * t).transpose() / 3;
    double cosine = 0, sine = 0;
    for (int t = 0; t < 3; ++t) {
      const Vec2 from = local[t] - middle,
                 to = corners.row(i).segment<2>(2 * t).transpose() - placed;
      cosine += from.dot(to);
      sine += wedge(from, to);
    }
    const double angle = std::atan2(sine, cosine);
    const Vec2 origin = placed - PlaneRotation(angle) * middle;
    poses.row(i) << origin.x(), origin.y(), angle;
  }
  return poses;
}

}  // namespace curveups
