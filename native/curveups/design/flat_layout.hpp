// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid poses of tiles in the flat configuration.
#pragma once

#include <array>
#include <string>

#include "curveups/design/tile_mesh.hpp"

namespace curveups {

// M x 3: x, y in mm of the frame's origin (front corner 0) and the angle in rad by which the tile's
// frame is turned. Rigidity (Eq. 8) holds by construction.
using FlatPoses = Array3;
// M x 6: x, y of the three front corners, in the order of F.
using FlatCorners = Array6;

struct PlaneRotation {
  double c, s;
  explicit PlaneRotation(double angle);
  Vec2 operator*(const Vec2& p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
};

// Throws InvalidInput, naming `name`, for another number of rows and for numbers that are not
// finite. values: corners or insets.
void require_row_per_tile(const Array6& values, int tile_count, const std::string& name);

FlatCorners flat_corners(const TileMesh& tiles, const FlatPoses& poses);

// The pose of each tile that fits its corners best (least squares, rigid).
FlatPoses fit_poses(const TileMesh& tiles, const FlatCorners& corners);

// The corners of one side of a tile, or of its pins, in the flat plane.
std::array<Vec2, 3> place(const FlatPoses& poses, int tile, const std::array<Vec2, 3>& local);

}  // namespace curveups
