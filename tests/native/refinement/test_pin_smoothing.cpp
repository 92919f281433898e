// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/design/pin_bounds.hpp"
#include "curveups/design/vertex_patch.hpp"
#include "curveups/refinement/pin_smoothing.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TriangleMesh ridge() {
  return test::lifted_patch(6, 7, [](double x, double y) { return -0.5 * std::hypot(x - 1, y); });
}

double least_largest_area(const TriangleMesh& mesh, const Parameters& parameters) {
  const DesignGeometry geometry = make_geometry(mesh, Edges(0, 2), parameters);
  double least = 1e300;
  for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
    for (Side side : {Side::front, Side::back}) {
      const PinRegion region =
          pin_region(geometry.tiles, geometry.truncation, parameters, i, side, parameters.p_min);
      least = std::min(least, region.area);
    }
  }
  return least;
}

TEST(PinSmoothing, MovesVerticesUntilEverySideReachesTheLeastArea) {
  const TriangleMesh mesh = ridge();
  Parameters parameters;
  parameters.A_pin_min = 1.1 * least_largest_area(mesh, parameters);
  const PinSmoothing smoothed = smooth_for_pins(mesh, Edges(0, 2), parameters, {});
  EXPECT_FALSE(smoothed.reached.empty());
  EXPECT_TRUE(smoothed.remaining.empty());
  EXPECT_GT(smoothed.largest_move, 0);
  EXPECT_LT((smoothed.mesh.V - mesh.V).cwiseAbs().maxCoeff(), parameters.L / 30 + 1e-9);
  EXPECT_GE(least_largest_area(smoothed.mesh, parameters), parameters.A_pin_min);
  // The movement stays where it is needed.
  const Eigen::VectorXd move = (smoothed.mesh.V - mesh.V).rowwise().norm();
  EXPECT_EQ(move(0), 0);
  EXPECT_LT(move.mean(), 0.3 * smoothed.largest_move);
}

TEST(PinSmoothing, LeavesAloneWhatNeedsNothingOrCannotBeHelped) {
  const TriangleMesh mesh = ridge();
  Parameters parameters;
  parameters.A_pin_min = 0.9 * least_largest_area(mesh, parameters);
  const PinSmoothing nothing = smooth_for_pins(mesh, Edges(0, 2), parameters, {});
  EXPECT_TRUE(nothing.remaining.empty());
  EXPECT_EQ(nothing.mesh.V, mesh.V);
  parameters.A_pin_min = 18;  // mm2 of the 21 that a tile has
  const PinSmoothing impossible = smooth_for_pins(mesh, Edges(0, 2), parameters, {});
  EXPECT_TRUE(impossible.reached.empty());
  EXPECT_FALSE(impossible.remaining.empty());
  EXPECT_EQ(impossible.mesh.V, mesh.V);
}

TEST(VertexPatch, RebuildsTheTilesAndInterfacesOfTheWholeDesign) {
  const TriangleMesh mesh = test::ripples();
  Edges cuts(2, 2);
  cuts << 30, 31, 31, 32;
  const Parameters parameters;
  const DesignGeometry whole = make_geometry(mesh, cuts, parameters);
  const VertexPatches patches(whole);
  int contacts = 0;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    const VertexPatch patch = patches.around(v);
    const LocalGeometry local = local_geometry(patch, mesh.V.row(v));
    for (int k : patch.changed) {
      for (int t = 0; t < 3; ++t) {
        EXPECT_LT((local.tiles.back[k][t] - whole.tiles.back[patch.tiles[k]][t]).norm(), 1e-12);
      }
    }
    ASSERT_EQ(patch.contacts.size(), local.patches.size());
    for (std::size_t k = 0; k < patch.contacts.size(); ++k) {
      if (patch.contacts[k] < 0) continue;
      ++contacts;
      const ContactPatch &a = local.patches[k], &b = whole.patches[patch.contacts[k]];
      ASSERT_EQ(a.point_count, b.point_count);
      for (int l = 0; l < a.point_count; ++l) EXPECT_LT((a.point[l] - b.point[l]).norm(), 1e-12);
    }
  }
  EXPECT_GT(contacts, 1000);
}

}  // namespace
}  // namespace curveups
