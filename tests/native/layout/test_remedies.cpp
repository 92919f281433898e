// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <set>

#include "curveups/layout/layout.hpp"
#include "curveups/layout/layout_figures.hpp"
#include "curveups/layout/remedies.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

Design solved(const TriangleMesh& mesh, const Parameters& p) {
  const DesignGeometry geometry = make_geometry(mesh, no_cuts, p);
  const LayoutResult result = solve_layout(geometry, p, {});
  return {"r", p, mesh, flat_corners(geometry.tiles, result.poses), result.q, no_cuts, {}};
}

std::vector<int> small_tiles(const DesignGeometry& geometry) {
  std::set<int> tiles;
  for (const SmallPin& pin : geometry.pin_bounds.small) tiles.insert(pin.tile);
  return {tiles.begin(), tiles.end()};
}

// The smallest of the largest pins that the tiles' bounds allow, truncation aside.
double least_room(const DesignGeometry& geometry, const std::vector<int>& tiles) {
  double least = 1e9;
  for (int i : tiles) {
    for (Side side : {Side::front, Side::back}) {
      least = std::min(least,
                       pin_area(geometry.tiles, i, side, geometry.pin_bounds.lower.row(i).data()));
    }
  }
  return least;
}

TEST(Remedies, ThinnerTilesGiveThePinsTheRoomTheyAreSaidToGive) {
  Parameters p;
  p.H_body = 6;
  const TriangleMesh mesh = test::dome(6, 7, 28);
  const Design design = solved(mesh, p);
  const std::vector<int> small = small_tiles(make_geometry(mesh, no_cuts, p));
  ASSERT_FALSE(small.empty());
  const Remedies remedies = find_remedies(design, small, {});
  ASSERT_TRUE(remedies.H_body.has_value());
  EXPECT_FALSE(remedies.tau.has_value());
  p.H_body = *remedies.H_body;
  EXPECT_GE(least_room(make_geometry(mesh, no_cuts, p), small), 1.25 * p.A_pin_min - 1e-9);
  p.H_body += 0.11;  // rounded to tenths, not farther off
  EXPECT_LT(least_room(make_geometry(mesh, no_cuts, p), small), 1.25 * p.A_pin_min);
}

TEST(Remedies, LargerTilesOnTheSameTargetDoSoToo) {
  Parameters p;
  p.H_body = 4;
  const double radius = 40;
  const TriangleMesh mesh = test::dome(8, 4.5, radius);
  p.L = 4.5;
  const Design design = solved(mesh, p);
  std::vector<int> all;
  for (int i = 0; i < mesh.F.rows(); ++i) all.push_back(i);
  const double before = least_room(make_geometry(mesh, no_cuts, p), all);
  ASSERT_LT(before, 1.25 * p.A_pin_min);
  const Remedies remedies = find_remedies(design, all, {});
  ASSERT_TRUE(remedies.L.has_value());
  p.L = *remedies.L;
  // About: tiles of another size lie elsewhere on the target.
  const TriangleMesh larger = test::dome(5, p.L, radius);
  all.resize(larger.F.rows());
  EXPECT_GT(least_room(make_geometry(larger, no_cuts, p), all), 0.85 * 1.25 * p.A_pin_min);
}

TEST(Remedies, MoreStretchMakesTheMembraneTautAtTheContactsNamed) {
  Parameters p;
  p.tau = 1.3;
  const TriangleMesh mesh = test::saddle(6);
  const Design design = solved(mesh, p);
  const DesignGeometry geometry = make_geometry(mesh, no_cuts, p);
  const FlatPoses poses = fit_poses(geometry.tiles, design.T);
  const Eigen::VectorXd before = spring_ratios(geometry, p, poses, design.q);
  Eigen::Index longest;
  ASSERT_GT(before.maxCoeff(&longest), 0.95);
  const std::array<int, 2> pair = geometry.tiles.contacts[longest / 2].tile;
  const Remedies remedies = find_remedies(design, {}, {{pair[1], pair[0]}});
  ASSERT_TRUE(remedies.tau.has_value());
  EXPECT_FALSE(remedies.H_body || remedies.L);
  p.tau = *remedies.tau;
  EXPECT_LE(spring_ratios(geometry, p, poses, design.q).maxCoeff(), 0.9 + 1e-9);
  // Where nothing is amiss, nothing is said.
  const Remedies none = find_remedies(solved(mesh, Parameters()), {}, {pair});
  EXPECT_FALSE(none.tau || none.H_body || none.L);
}

}  // namespace
}  // namespace curveups
