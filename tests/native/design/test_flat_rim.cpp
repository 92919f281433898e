// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/design/flat_rim.hpp"

namespace curveups {
namespace {

using Pairs = std::vector<std::array<int, 2>>;
constexpr double degree = M_PI / 180;

// Six tiles around vertex 0, slit along the edge to vertex 1 or not.
TileMesh fan(bool slit) {
  TriangleMesh mesh{Points3::Zero(7, 3), Triangles(6, 3)};
  for (int k = 0; k < 6; ++k) {
    mesh.V.row(k + 1) << 10 * std::cos(60 * k * degree), 10 * std::sin(60 * k * degree), 0;
    mesh.F.row(k) << 0, k + 1, (k + 1) % 6 + 1;
  }
  Edges cuts(slit ? 1 : 0, 2);
  if (slit) cuts << 0, 1;
  return make_tile_mesh(mesh, cuts, 0.1);
}

// Tiles one after the other around the origin; each takes `angle` there and is 2 mm off.
Points2 turned(double angle) {
  Points2 corners(18, 2);
  for (int k = 0; k < 6; ++k) {
    const auto at = [](double turn, double radius) {
      return Eigen::RowVector2d(radius * std::cos(turn), radius * std::sin(turn));
    };
    const auto from = at((k + 0.5) * angle, 2);
    corners.row(3 * k) = from;
    corners.row(3 * k + 1) = from + at(k * angle, 10);
    corners.row(3 * k + 2) = from + at((k + 1) * angle, 10);
  }
  return corners;
}

TEST(FlatRim, SidesOfACutThatLieApartDoNotCross) {
  EXPECT_EQ(crossing_rims(fan(true), turned(55 * degree)), Pairs());
  EXPECT_EQ(crossing_rims(fan(true), turned(60 * degree)), Pairs());
}

TEST(FlatRim, SidesOfACutWithMoreThanTheFullAngleCross) {
  EXPECT_EQ(crossing_rims(fan(true), turned(66 * degree)), (Pairs{{0, 5}}));
}

TEST(FlatRim, TilesThatKeepApartDoNotHideIt) {
  // Tile 5 turned past tile 0, and drawn out until it lies beyond it.
  Points2 corners = turned(66 * degree);
  const Eigen::RowVector2d away = 14 * Eigen::RowVector2d(std::cos(0.3), std::sin(0.3));
  for (int c = 0; c < 3; ++c) corners.row(15 + c) += away;
  EXPECT_FALSE(crossing_rims(fan(true), corners).empty());
}

TEST(FlatRim, WithoutACutTheMiddleIsClosed) {
  EXPECT_EQ(crossing_rims(fan(false), turned(60 * degree)), Pairs());
  const TileMesh whole = fan(false), slit = fan(true);
  EXPECT_EQ(open_vertices(whole), (std::vector<char>{0, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(open_vertices(slit), (std::vector<char>{1, 1, 1, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace curveups
