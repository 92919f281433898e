// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "curveups/design/design.hpp"
#include "curveups/design/pin_bounds.hpp"
#include "curveups/design/print_constants.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

Parameters without_bumps() {
  Parameters p;
  p.bumps = "none";
  p.xy_compensation = 0;
  return p;
}

TEST(Pins, AreaIsThatOfTheCorners) {
  const TileMesh tiles = make_tile_mesh(test::dome(4), no_cuts, 3);
  const double q[6] = {0.7, 0.9, 1.1, 0.65, 0.8, 0.6};
  for (Side side : {Side::front, Side::back}) {
    const auto c = pin_corners(tiles, 5, side, q);
    EXPECT_NEAR(pin_area(tiles, 5, side, q), 0.5 * wedge(c[1] - c[0], c[2] - c[0]), 1e-12);
  }
  const double turned[6] = {5, 5, 5, 5, 5, 5};
  EXPECT_LT(pin_area(tiles, 5, Side::front, turned), 0);
}

TEST(Pins, FoldsLimitInsetsAtPinLevel) {
  // 1.6 rad: concave behind, so that facing back pins meet where q < H tan(0.8).
  const double dihedral = 1.6;
  const Parameters p = without_bumps();
  const DesignGeometry geometry = make_geometry(test::hinge(dihedral, 20), no_cuts, p);
  const Contact& contact = geometry.tiles.contacts[0];
  const int t = contact.side[0];
  EXPECT_NEAR(geometry.pin_bounds.lower(0, inset_index(Side::back, t)),
              std::tan(0.8) + pin_clearance, 1e-12);
  EXPECT_NEAR(geometry.pin_bounds.upper(0, inset_index(Side::front, t)),
              1 / std::tan(0.8) - pin_clearance, 1e-12);
  EXPECT_EQ(geometry.pin_bounds.lower(0, inset_index(Side::front, t)), p.p_min);
  EXPECT_EQ(geometry.pin_bounds.upper(0, inset_index(Side::front, next3(t))), p.p_max);
  // At those insets the pins' top edges really meet, and the chord touches the edge.
  const RigidMotion &a = geometry.tiles.frame[0], &b = geometry.tiles.frame[1];
  double q[6];
  std::fill(q, q + 6, 1.0);
  q[inset_index(Side::back, t)] = std::tan(0.8);
  const auto pin_a = pin_corners(geometry.tiles, 0, Side::back, q);
  std::fill(q, q + 6, 1.0);
  q[inset_index(Side::back, contact.side[1])] = std::tan(0.8);
  const auto pin_b = pin_corners(geometry.tiles, 1, Side::back, q);
  const Vec3 pa = a(Vec3(pin_a[t].x(), pin_a[t].y(), -4));
  const int u = contact.side[1];
  const Vec3 pb = b(Vec3(pin_b[u].x(), pin_b[u].y(), -4));
  EXPECT_NEAR(pa.x(), 0, 1e-9);
  EXPECT_NEAR(pb.x(), 0, 1e-9);
}

TEST(Pins, PMinCountsFromTheRecessedEdge) {
  Parameters p;
  const double dihedral = 0.2;
  const DesignGeometry geometry = make_geometry(test::hinge(dihedral), no_cuts, p);
  const int t = geometry.tiles.contacts[0].side[0];
  EXPECT_NEAR(geometry.pin_bounds.lower(0, inset_index(Side::front, t)),
              p.p_min + 0.5 * p.bump_height / std::cos(0.1), 1e-12);
  EXPECT_EQ(geometry.pin_bounds.lower(0, inset_index(Side::front, next3(t))), p.p_min);
  EXPECT_EQ(wall_recess(p), 0.5 * p.bump_height);
  // Walls that meet stand back by what prints grow.
  for (const char* bumps : {"dimples", "none"}) {
    p.bumps = bumps;
    EXPECT_EQ(wall_recess(p), p.xy_compensation);
  }
}

TEST(Pins, SidesThatCannotReachTheAreaAreNamedWithTheirLargest) {
  Parameters p = without_bumps();
  const TileMesh tiles = make_tile_mesh(test::cone(), no_cuts, p.H_body);
  const Truncation truncation = truncate_at_vertices(tiles);
  const PinBounds bounds = compute_pin_bounds(tiles, truncation, p);
  ASSERT_FALSE(bounds.small.empty());
  for (const SmallPin& pin : bounds.small) {
    EXPECT_LT(pin.area, p.A_pin_min * 1.001);
    EXPECT_EQ(pin.side, Side::back);
    EXPECT_LT(bounds.least_area(pin.tile, 1), pin.area);
  }
  // The most that bounds allow: with lower bounds where no plane is near, less elsewhere.
  for (const SmallPin& pin : bounds.small) {
    EXPECT_LE(pin.area,
              pin_area(tiles, pin.tile, pin.side, bounds.lower.row(pin.tile).data()) + 1e-9);
  }
}

// p_min gives way where folds leave less than A_pin_floor, never beyond p_floor, and is listed.
TEST(Pins, WhatGivesWayIsListedAndKeepsTheFloor) {
  Parameters p = without_bumps();
  const TileMesh tiles = make_tile_mesh(test::cone(), no_cuts, p.H_body);
  const Truncation truncation = truncate_at_vertices(tiles);
  const int tile = 0;
  auto area_with = [&](double p_min) {
    return pin_region(tiles, truncation, p, tile, Side::back, p_min).area;
  };
  const double asked = area_with(p.p_min), most = area_with(p.p_floor);
  ASSERT_GT(most, 1.1 * asked);
  p.A_pin_min = 2 * most;
  auto of_tile = [&](const PinBounds& bounds) {
    std::vector<RelaxedBound> out;
    for (const RelaxedBound& bound : bounds.relaxed) {
      if (bound.tile == tile && bound.side == Side::back && bound.what == "p_min") {
        out.push_back(bound);
      }
    }
    return out;
  };
  p.A_pin_floor = 0.9 * asked;
  EXPECT_TRUE(of_tile(compute_pin_bounds(tiles, truncation, p)).empty());
  p.A_pin_floor = 0.5 * (asked + most);
  const PinBounds enough = compute_pin_bounds(tiles, truncation, p);
  ASSERT_EQ(of_tile(enough).size(), 3u);
  for (const RelaxedBound& bound : of_tile(enough)) {
    EXPECT_EQ(bound.from, p.p_min);
    EXPECT_GT(bound.to, p.p_floor);
    EXPECT_LT(bound.to, p.p_min);
    EXPECT_EQ(enough.lower(tile, inset_index(Side::back, bound.edge)), bound.to);
  }
  EXPECT_GE(pin_region(tiles, truncation, p, tile, Side::back, of_tile(enough)[0].to).area,
            p.A_pin_floor);
  // The side is too small even with p_floor: it is listed, and p_floor holds.
  p.A_pin_floor = 1.5 * most;
  const PinBounds short_of_it = compute_pin_bounds(tiles, truncation, p);
  ASSERT_EQ(of_tile(short_of_it).size(), 3u);
  for (const RelaxedBound& bound : of_tile(short_of_it)) EXPECT_EQ(bound.to, p.p_floor);
  EXPECT_GE(short_of_it.lower.minCoeff(), p.p_floor);
  EXPECT_TRUE(
      std::any_of(short_of_it.small.begin(), short_of_it.small.end(), [&](const SmallPin& pin) {
        return pin.tile == tile && pin.side == Side::back && std::abs(pin.area - most) < 1e-9;
      }));
  // Nothing is relaxed with p_floor = p_min.
  p.p_floor = p.p_min;
  EXPECT_TRUE(of_tile(compute_pin_bounds(tiles, truncation, p)).empty());
}

// On a convex fold sharper than pins can be drawn in for: lower wins, and that is listed.
TEST(Pins, UpperBoundsThatContradictLowerOnesGiveWay) {
  const Parameters p = without_bumps();
  const DesignGeometry geometry = make_geometry(test::hinge(2.2, 20), no_cuts, p);
  const Contact& contact = geometry.tiles.contacts[0];
  bool listed = false;
  for (const RelaxedBound& bound : geometry.pin_bounds.relaxed) {
    if (bound.what != "p_max" || bound.tile != 0) continue;
    listed = true;
    EXPECT_EQ(bound.edge, contact.side[0]);
    EXPECT_EQ(bound.side, Side::front);
    EXPECT_NEAR(bound.from, p.H_pin / std::tan(1.1) - pin_clearance, 1e-12);
    EXPECT_EQ(bound.to, geometry.pin_bounds.upper(0, inset_index(Side::front, bound.edge)));
    EXPECT_GT(bound.to, bound.from);
  }
  EXPECT_TRUE(listed);
}

TEST(Pins, KeepoutsHoldCornersInsideTruncationPlanes) {
  const Parameters p = without_bumps();
  std::srand(4);
  TriangleMesh mesh = test::ripples(6);
  for (int v = 0; v < mesh.V.rows(); ++v) mesh.V.row(v) += 0.9 * Eigen::RowVector3d::Random();
  const DesignGeometry geometry = make_geometry(mesh, no_cuts, p);
  const PinBounds& bounds = geometry.pin_bounds;
  ASSERT_FALSE(bounds.keepouts.empty());
  std::srand(1);
  int tried = 0, reached = 0;
  for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
    for (int k = 0; k < 40; ++k) {
      double q[6];
      for (int n = 0; n < 6; ++n) {
        const double r = 0.5 + 0.5 * Eigen::internal::random<double>(-1, 1);
        q[n] =
            bounds.lower(i, n) + r * r * (std::min(1.5, bounds.upper(i, n)) - bounds.lower(i, n));
      }
      bool kept = true;
      for (const PinKeepout& keepout : bounds.keepouts) {
        if (keepout.tile != i) continue;
        const double* own = q + inset_index(keepout.side, 0);
        kept &=
            keepout.a_prev * own[prev3(keepout.corner)] + keepout.a_here * own[keepout.corner] >=
            keepout.bound;
      }
      if (pin_area(geometry.tiles, i, Side::back, q) < 0.5) continue;
      bool inside = true;
      const auto corners = pin_corners(geometry.tiles, i, Side::back, q);
      for (const TruncationPlane& plane : geometry.truncation.of_tile[i]) {
        for (const Vec2& c : corners) {
          for (double z : {-3.0, -4.0}) {
            inside &= plane.plane.distance(Vec3(c.x(), c.y(), z)) <= 1e-9;
          }
        }
      }
      ++tried;
      reached += !inside;
      EXPECT_TRUE(inside || !kept) << "tile " << i;
    }
  }
  EXPECT_GT(tried, 500);
  EXPECT_GT(reached, 0);  // some pins would have been cut
}

}  // namespace
}  // namespace curveups
