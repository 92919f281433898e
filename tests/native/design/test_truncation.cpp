// SPDX-License-Identifier: LGPL-2.1-or-later
// Truncated tiles do not overlap when actuated, whatever the shape, and lose nothing they need not.
#include <gtest/gtest.h>

#include "curveups/core/tolerances.hpp"
#include "curveups/design/contacts.hpp"
#include "curveups/design/remote_overlaps.hpp"
#include "curveups/design/truncation.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

double overlap(const TileMesh& tiles, const Truncation& truncation, int i, int j) {
  ConvexBody body = tile_body(tiles, truncation, i);
  const ConvexBody other = tile_body(tiles, truncation, j);
  for (const BodyFace& face : other.faces) {
    const Vec3 normal = tiles.frame[i].R.transpose() * (tiles.frame[j].R * face.plane.normal);
    const Vec3 point = tiles.frame[i].to_own(tiles.frame[j](other.points[face.loop[0]]));
    clip(body, {normal, normal.dot(point)}, body_tag::cut);
    if (body.faces.empty()) return 0;
  }
  return volume(body);
}

double largest_overlap(const TileMesh& tiles, const Truncation& truncation) {
  double largest = 0;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int j = i + 1; j < tiles.tile_count(); ++j) {
      if ((tiles.frame[i].t - tiles.frame[j].t).norm() > 30) continue;
      largest = std::max(largest, overlap(tiles, truncation, i, j));
    }
  }
  return largest;
}

TriangleMesh rough(unsigned seed) {
  std::srand(seed);
  TriangleMesh mesh = test::ripples(6);
  for (int v = 0; v < mesh.V.rows(); ++v) {
    mesh.V.row(v) += 0.9 * Eigen::RowVector3d::Random();
  }
  return mesh;
}

TEST(Truncation, TilesOfRoughSurfacesDoNotOverlap) {
  std::array<int, 5> types{};
  for (unsigned seed = 0; seed < 12; ++seed) {
    const TileMesh tiles = make_tile_mesh(rough(seed), no_cuts, 3);
    ASSERT_TRUE(tiles_without_back(tiles).empty());
    Truncation truncation = truncate_at_vertices(tiles);
    auto patches = compute_contact_patches(tiles, truncation);
    separate_remote_tiles(tiles, patches, truncation);
    EXPECT_TRUE(truncation.unresolved.empty()) << "seed " << seed;
    EXPECT_LE(largest_overlap(tiles, truncation), tolerance::overlap_volume) << "seed " << seed;
    for (int t = 1; t <= 4; ++t) types[t] += truncation.pairs_of_type[t];
    if (seed == 0) {
      // The test would see it: without the planes there are overlaps.
      Truncation none;
      none.of_tile.resize(tiles.tile_count());
      EXPECT_GT(largest_overlap(tiles, none), 1e-3);
    }
  }
  EXPECT_GT(types[1], 50);
  EXPECT_GT(types[2], 50);
  EXPECT_GT(types[3], 5);  // the type that the paper denies
}

TEST(Truncation, FrontFacesAreNeverCut) {
  const TileMesh tiles = make_tile_mesh(rough(3), no_cuts, 3);
  const Truncation truncation = truncate_at_vertices(tiles);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (const TruncationPlane& t : truncation.of_tile[i]) {
      for (const Vec2& p : tiles.front[i]) {
        EXPECT_LE(t.plane.distance(Vec3(p.x(), p.y(), 0)), tolerance::snap);
      }
    }
  }
}

TEST(Truncation, FlatTilesNeedNone) {
  const TileMesh tiles = make_tile_mesh(test::flat_patch(4), no_cuts, 3);
  const Truncation truncation = truncate_at_vertices(tiles);
  for (const auto& planes : truncation.of_tile) EXPECT_TRUE(planes.empty());
}

TEST(Truncation, LipsOfACutAreKeptApartToo) {
  const TriangleMesh mesh = rough(5);
  const TileMesh whole = make_tile_mesh(mesh, no_cuts, 3);
  const MeshEdge& edge = whole.topology.edges[whole.contacts[40].edge];
  Edges cuts(1, 2);
  cuts << edge.v[0], edge.v[1];
  const TileMesh tiles = make_tile_mesh(mesh, cuts, 3);
  EXPECT_LE(largest_overlap(tiles, truncate_at_vertices(tiles)), tolerance::overlap_volume);
}

TEST(RemoteOverlaps, LipsOfASlitOnARidgeAreSeparated) {
  // A ridge along which the target is open: both lips have upright walls, which cross behind.
  TriangleMesh mesh = test::hinge(0.3);
  mesh.V.conservativeResize(6, 3);
  mesh.V.row(4) = mesh.V.row(1);
  mesh.V.row(5) = mesh.V.row(0);
  mesh.F.row(1) << 4, 5, 3;
  const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
  Truncation truncation = truncate_at_vertices(tiles);
  EXPECT_GT(largest_overlap(tiles, truncation), 1);
  auto patches = compute_contact_patches(tiles, truncation);
  separate_remote_tiles(tiles, patches, truncation);
  EXPECT_EQ(truncation.pairs_of_type[4], 1);
  EXPECT_TRUE(truncation.unresolved.empty());
  EXPECT_LE(largest_overlap(tiles, truncation), tolerance::overlap_volume);
  // Symmetry takes the same from each, by the bisector plane.
  EXPECT_NEAR(volume(tile_body(tiles, truncation, 0)), volume(tile_body(tiles, truncation, 1)),
              1e-9);
}

// Two flat patches face to face: front pins of 1 mm need 2 mm.
TEST(RemoteOverlaps, FrontPinsOfSheetsThatFaceOneAnotherAreParted) {
  const TriangleMesh patch = test::flat_patch(2);
  const int n = static_cast<int>(patch.V.rows()), m = static_cast<int>(patch.F.rows());
  TriangleMesh both;
  both.V.resize(2 * n, 3);
  both.F.resize(2 * m, 3);
  both.V << patch.V, patch.V;
  both.F << patch.F, patch.F.array() + n;
  both.F.bottomRows(m).col(1).swap(both.F.bottomRows(m).col(2));  // facing down
  auto planes = [&](double apart) {
    both.V.bottomRows(n).col(2).setConstant(apart);
    const TileMesh tiles = make_tile_mesh(both, no_cuts, 3);
    Truncation truncation = truncate_at_vertices(tiles);
    separate_remote_front_pins(tiles, 1, truncation);
    int count = 0;
    for (int i = 0; i < tiles.tile_count(); ++i) {
      for (const TruncationPlane& t : truncation.front_pins[i]) {
        ++count;
        // Half-way, in the tile's frame.
        EXPECT_NEAR(std::abs(t.plane.normal.z()), 1, 1e-9);
        EXPECT_NEAR(t.plane.offset * t.plane.normal.z(), 0.5 * apart, 1e-9);
        EXPECT_NE(t.other < m, i < m);
      }
      EXPECT_TRUE(truncation.of_tile[i].empty());  // bodies stay
    }
    return count;
  };
  EXPECT_GT(planes(1.6), 0);
  EXPECT_EQ(planes(2.1), 0);
}

TEST(RemoteOverlaps, SheetsNearerThanTwoBodiesAreAnErrorOfTheTarget) {
  // Two flat patches back to back, 4 mm apart, with bodies of 3 mm: contacts reach to the back.
  const TriangleMesh patch = test::flat_patch(2);
  const int n = static_cast<int>(patch.V.rows()), m = static_cast<int>(patch.F.rows());
  TriangleMesh both;
  both.V.resize(2 * n, 3);
  both.F.resize(2 * m, 3);
  both.V << patch.V, patch.V;
  both.V.bottomRows(n).col(2).array() -= 4;
  both.F << patch.F, patch.F.array() + n;
  both.F.bottomRows(m).col(1).swap(both.F.bottomRows(m).col(2));  // facing down
  const TileMesh tiles = make_tile_mesh(both, no_cuts, 3);
  Truncation truncation = truncate_at_vertices(tiles);
  auto patches = compute_contact_patches(tiles, truncation);
  separate_remote_tiles(tiles, patches, truncation);
  EXPECT_FALSE(truncation.unresolved.empty());
  for (const auto& [i, j] : truncation.unresolved) EXPECT_TRUE(i < m && j >= m);
}

}  // namespace
}  // namespace curveups
