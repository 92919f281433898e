// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/core/errors.hpp"
#include "curveups/design/tile_mesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

TEST(TileMesh, FoldIsPositiveOnARidgeAndBackShrinksByHTanHalf) {
  for (double dihedral : {0.4, -0.3, 0.0}) {
    const TileMesh tiles = make_tile_mesh(test::hinge(dihedral), no_cuts, 3);
    ASSERT_EQ(tiles.contacts.size(), 1u);
    const Contact& contact = tiles.contacts[0];
    EXPECT_NEAR(tiles.dihedral(contact.tile[0], contact.side[0]), dihedral, 1e-12);
    EXPECT_NEAR(tiles.back_shift(0, contact.side[0]), 3 * std::tan(0.5 * dihedral), 1e-12);
    for (int t = 0; t < 3; ++t) {
      if (t != contact.side[0]) {
        EXPECT_EQ(tiles.back_shift(0, t), 0);
      }
    }
  }
}

TEST(TileMesh, WallsOfNeighboursLieInOneBisectorPlane) {
  for (const TriangleMesh& mesh : {test::dome(), test::saddle(), test::ripples()}) {
    const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
    for (const Contact& contact : tiles.contacts) {
      const int i = contact.tile[0], j = contact.tile[1];
      const Vec3 a = tiles.frame[i].R * tiles.wall_normal(i, contact.side[0]);
      const Vec3 b = tiles.frame[j].R * tiles.wall_normal(j, contact.side[1]);
      EXPECT_LT((a + b).norm(), 1e-12);
      // Both back edges lie in that plane.
      const Vec3 through = mesh.V.row(tiles.topology.edges[contact.edge].v[0]);
      for (int s = 0; s < 2; ++s) {
        const int tile = contact.tile[s], t = contact.side[s];
        for (int corner : {t, next3(t)}) {
          const Vec2& p = tiles.back[tile][corner];
          const Vec3 world = tiles.frame[tile](Vec3(p.x(), p.y(), -3));
          EXPECT_NEAR(a.dot(world - through), 0, 1e-11);
        }
      }
    }
  }
}

TEST(TileMesh, InsetTriangleMovesEachEdgeByItsDistance) {
  const std::array<Vec2, 3> triangle = {Vec2(0, 0), Vec2(7, 1), Vec2(2, 6)};
  const std::array<double, 3> distance = {0.4, -0.2, 0.9};
  const auto inset = inset_triangle(triangle, distance);
  for (int t = 0; t < 3; ++t) {
    const Vec2 edge = (triangle[next3(t)] - triangle[t]).normalized();
    EXPECT_NEAR(wedge(edge, inset[t] - triangle[t]), distance[t], 1e-12);
    EXPECT_NEAR(wedge(edge, inset[next3(t)] - triangle[t]), distance[t], 1e-12);
  }
}

TEST(TileMesh, NamesTilesWhoseBackVanishes) {
  // Three faces of a sharp pyramid: the tip's tiles have no room for a back of 3 mm.
  TriangleMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0, 0, 12, 4, 0, 0, -2, 3.46, 0, -2, -3.46, 0;
  mesh.F.resize(3, 3);
  mesh.F << 0, 1, 2, 0, 2, 3, 0, 3, 1;
  EXPECT_EQ(tiles_without_back(make_tile_mesh(mesh, no_cuts, 3)), (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(tiles_without_back(make_tile_mesh(mesh, no_cuts, 0.3)).empty());
}

TEST(TileMesh, CutsRemoveContactsAndKeepFolds) {
  const TriangleMesh mesh = test::hinge(0.3);
  Edges cuts(1, 2);
  cuts << 1, 0;
  const TileMesh tiles = make_tile_mesh(mesh, cuts, 3);
  EXPECT_TRUE(tiles.contacts.empty());
  EXPECT_NEAR(tiles.dihedral.maxCoeff(), 0.3, 1e-12);
  cuts << 0, 2;
  EXPECT_THROW(make_tile_mesh(mesh, cuts, 3), InvalidInput);  // a boundary edge
}

TEST(TileMesh, RefusesWhatIsNoSurface) {
  TriangleMesh mesh = test::hinge(0.3);
  mesh.V(2, 1) = std::nan("");
  EXPECT_THROW(make_tile_mesh(mesh, no_cuts, 3), InvalidInput);
  mesh = test::hinge(0.3);
  mesh.V.row(2) = 0.5 * (mesh.V.row(0) + mesh.V.row(1));
  EXPECT_THROW(make_tile_mesh(mesh, no_cuts, 3), InvalidInput);
}

}  // namespace
}  // namespace curveups
