// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/design/tile_shapes.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using Corners = Eigen::Map<const Eigen::Matrix<double, 6, 3, Eigen::RowMajor>>;

// Volume of the prism or frustum between corners 0 to 2 and 3 to 5, by the prismoidal formula:
// exact for faces with parallel edges.
double volume(const Corners& c) {
  const auto area = [](const Vec3& a, const Vec3& b, const Vec3& d) {
    return 0.5 * (b - a).cross(d - a).norm();
  };
  const auto middle = [&](int t) { return Vec3(0.5 * (c.row(t) + c.row(t + 3))); };
  const Vec3 normal = Vec3(c.row(1) - c.row(0)).cross(Vec3(c.row(2) - c.row(0))).normalized();
  const double height = std::abs(normal.dot(Vec3(c.row(3) - c.row(0))));
  return height / 6 *
         (area(c.row(0), c.row(1), c.row(2)) + 4 * area(middle(0), middle(1), middle(2)) +
          area(c.row(3), c.row(4), c.row(5)));
}

TileShapes shapes_of(const Design& design) {
  return tile_shapes(design.mesh, design.cuts, design.parameters, design.T, design.q);
}

TEST(TileShapes, FlatAndActuatedDifferByARigidMotionOfEachTile) {
  const Design design = test::sample_design();
  const TileShapes shapes = shapes_of(design);
  for (int i = 0; i < design.mesh.F.rows(); ++i) {
    // All twelve plus six points of tile and pins: mutual distances are the same.
    Eigen::Matrix<double, 18, 3, Eigen::RowMajor> actuated, flat;
    actuated << Corners(shapes.actuated.row(i).data()), Corners(shapes.actuated_pins.row(i).data()),
        Corners(shapes.actuated_pins.row(i).data() + 18);
    flat << Corners(shapes.flat.row(i).data()), Corners(shapes.flat_pins.row(i).data()),
        Corners(shapes.flat_pins.row(i).data() + 18);
    for (int a = 0; a < 18; ++a) {
      for (int b = 0; b < a; ++b) {
        EXPECT_NEAR((actuated.row(a) - actuated.row(b)).norm(), (flat.row(a) - flat.row(b)).norm(),
                    1e-9);
      }
    }
    for (int t = 0; t < 3; ++t) {
      EXPECT_LT((actuated.row(t) - design.mesh.V.row(design.mesh.F(i, t))).norm(), 1e-9);
      EXPECT_LT((flat.row(t).head<2>() - design.T.row(i).segment<2>(2 * t)).norm(), 1e-9);
      EXPECT_EQ(flat(t, 2), 0);
      EXPECT_EQ(flat(3 + t, 2), -design.parameters.H_body);
    }
    EXPECT_GT(wedge(Vec2(flat.row(1).head<2>() - flat.row(0).head<2>()),
                    Vec2(flat.row(2).head<2>() - flat.row(0).head<2>())),
              0);
  }
}

TEST(TileShapes, VolumesAreThoseOfFrustumsAndPrisms) {
  const Design design = test::sample_design();
  const TileShapes shapes = shapes_of(design);
  const TileMesh tiles = make_tile_mesh(design.mesh, design.cuts, design.parameters.H_body);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const ConvexBody body =
        make_frustum(tiles.front[i], 0, tiles.back[i], -design.parameters.H_body);
    EXPECT_NEAR(volume(Corners(shapes.actuated.row(i).data())), volume(body), 1e-9);
    for (Side side : {Side::front, Side::back}) {
      const int s = static_cast<int>(side);
      EXPECT_NEAR(volume(Corners(shapes.flat_pins.row(i).data() + 18 * s)),
                  design.parameters.H_pin * pin_area(tiles, i, side, design.q.row(i).data()), 1e-9);
    }
  }
}

TEST(TileShapes, TilesOfAHingeMeetInTheBisectorPlane) {
  const double dihedral = 0.7;
  const TriangleMesh mesh = test::hinge(dihedral);
  const TileShapes shapes = tile_shapes(mesh, Edges(0, 2), Parameters(), {}, {});
  EXPECT_EQ(shapes.flat.rows(), 0);
  EXPECT_EQ(shapes.actuated_pins.rows(), 0);
  ASSERT_EQ(shapes.contacts.rows(), 1);
  const Vec3 start = mesh.V.row(mesh.F(shapes.contacts(0, 0), shapes.contact_sides(0, 0)));
  for (int s = 0; s < 2; ++s) {
    const int tile = shapes.contacts(0, s), t = shapes.contact_sides(0, s);
    const Corners c(shapes.actuated.row(tile).data());
    // The edge runs along y at x = 0; the bisector plane is x = 0, on which both back edges lie.
    EXPECT_NEAR((c.row(s == 0 ? t : next3(t)) - start.transpose()).norm(), 0, 1e-12);
    EXPECT_NEAR(c(3 + t, 0), 0, 1e-9);
    EXPECT_NEAR(c(3 + next3(t), 0), 0, 1e-9);
    // H / cos(fold / 2) below the edge.
    EXPECT_NEAR(std::abs(c(3 + t, 2) - start.z()), Parameters().H_body / std::cos(dihedral / 2),
                1e-9);
  }
}

TEST(TileShapes, WhatIsNoLayoutIsRefused) {
  Design design = test::sample_design();
  design.T(3, 4) = std::numeric_limits<double>::quiet_NaN();
  try {
    shapes_of(design);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{3});
    EXPECT_NE(std::string(error.what()).find("T "), std::string::npos);
  }
  design = test::sample_design();
  design.q.conservativeResize(design.q.rows() - 1, Eigen::NoChange);
  EXPECT_THROW(shapes_of(design), InvalidInput);
  design = test::sample_design();
  design.parameters.H_body = 400;
  EXPECT_THROW(shapes_of(design), InfeasibleDesign);
}

}  // namespace
}  // namespace curveups
