// SPDX-License-Identifier: LGPL-2.1-or-later
// Piece with given poses of its tiles: poses of its TileWorld, and stretch of its membranes.
#pragma once

#include "curveups/contact/tile_world.hpp"

namespace curveups {

// Tiles of the layout, in the plane z = 0 with their fronts up, about their centres (tile_centres)
// as the TileWorld's bodies are.
Poses flat_tiles(const TileBodies& bodies);

// Poses of the tiles in files: a row a tile, its motion from its place in the actuated design, as
// x, y, z (mm) and a unit quaternion (w, x, y, z): a point p goes to R p + (x, y, z).
using FrameRows = Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>;
FrameRows frame_rows(const TileMesh& tiles, const Poses& poses);
// Motions of these rows. Throws InvalidInput where there is not a row a tile, or one is no rigid
// motion.
std::vector<RigidMotion> frame_motions(const FrameRows& rows, int tile_count);

// Poses of all bodies of a piece without a ground, with the tiles at these poses and each node
// of the membranes amid the pins around it.
Poses piece_poses(const TileWorld& piece, const Poses& tiles);

// Mean over all contacts and both sides of the membrane's stretch ratio between facing pin edges:
// tau where tiles are flat.
double mean_stretch(const TileWorld& piece, const TileBodies& bodies);

}  // namespace curveups
