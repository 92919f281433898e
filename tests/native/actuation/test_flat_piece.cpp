// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/actuation/flat_piece.hpp"
#include "curveups/core/errors.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

TEST(FlatPiece, StandsWhereTheLayoutHasIt) {
  const Design design = sample_design();
  const TileBodies bodies = make_tile_bodies(design);
  const TileMesh& tiles = bodies.geometry.tiles;
  const Points3 centres = tile_centres(tiles);
  const Poses flat = flat_tiles(bodies);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 corner = tiles.mesh.V.row(tiles.mesh.F(i, c)) - centres.row(i);
      const Vec3 there = flat[i](corner);
      EXPECT_NEAR(there.x(), design.T(i, 2 * c), 1e-9);
      EXPECT_NEAR(there.y(), design.T(i, 2 * c + 1), 1e-9);
      EXPECT_NEAR(there.z(), 0, 1e-9);
    }
    EXPECT_NEAR((flat[i].R * tiles.normal(i)).z(), 1, 1e-12);  // fronts up
  }
}

TEST(FlatPiece, FramesAreMotionsFromTheActuatedDesign) {
  const Design design = sample_design();
  const TileBodies bodies = make_tile_bodies(design);
  const TileMesh& tiles = bodies.geometry.tiles;
  const Poses flat = flat_tiles(bodies);
  const FrameRows rows = frame_rows(tiles, flat);
  const std::vector<RigidMotion> motions = frame_motions(rows, tiles.tile_count());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    EXPECT_LT((motions[i].R - flat[i].R).norm(), 1e-12);
    EXPECT_NEAR(motions[i](tiles.mesh.V.row(tiles.mesh.F(i, 0))).x(), design.T(i, 0), 1e-9);
  }
  FrameRows bad = rows;
  bad.row(3).tail<4>() *= 1.1;
  try {
    frame_motions(bad, tiles.tile_count());
    FAIL() << "no rigid motion was taken for one";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{3});
  }
  EXPECT_THROW(frame_motions(rows.topRows(4), tiles.tile_count()), InvalidInput);
}

}  // namespace
}  // namespace curveups::test
