// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/height_bound.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

constexpr double any = 1e9;

// A plate of 8 x 8 mm, bent.
TriangleMesh bowl(int parts) {
  TriangleMesh out = test::flat_square(parts, 8);
  for (int v = 0; v < out.V.rows(); ++v) {
    const double x = out.V(v, 0) - 4, y = out.V(v, 1) - 4;
    out.V(v, 2) = 0.02 * (x * x + y * y);
  }
  return out;
}

double bound_of(const TriangleMesh& surface, const std::array<Vec3, 3>& triangle,
                double most = any) {
  const Vec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3;
  return HeightBound(surface)(triangle, ClosestPoints(surface)(middle).face, most);
}

TEST(HeightBound, IsTheLargestHeightAndNoLessThanAnyDistance) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(1, 7), height(-0.3, 0.6);
  const TriangleMesh surface = bowl(9);
  const ClosestPoints closest(surface);
  int known = 0;
  for (int round = 0; round < 60; ++round) {
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) corner = Vec3(place(random), place(random), height(random));
    const Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (across.norm() < 1 || std::abs(across.z()) < 0.9 * across.norm()) continue;
    const double bound = bound_of(surface, corners);
    const double upright = std::abs(across.z()) / across.norm();
    double distance = 0, over = 0;
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; i + j <= 60; ++j) {
        const Vec3 at = (i * corners[0] + j * corners[1] + (60 - i - j) * corners[2]) / 60;
        const double here = closest(at).distance;
        distance = std::max(distance, here);
        over = std::max(over, here / upright);
      }
    }
    ASSERT_TRUE(std::isfinite(bound)) << round;
    EXPECT_GE(bound, distance - 1e-12) << round;
    EXPECT_LE(bound, 1.3 * over + 0.05) << round;
    EXPECT_EQ(bound_of(surface, corners, bound), bound);
    EXPECT_TRUE(std::isinf(bound_of(surface, corners, 0.99 * bound)));
    ++known;
  }
  EXPECT_GT(known, 20);
}

TEST(HeightBound, OfPlatesIsExact) {
  const TriangleMesh plate = test::flat_square(7, 8);
  EXPECT_NEAR(bound_of(plate, {Vec3(1, 1, 0), Vec3(7, 1, 0), Vec3(1, 7, 0.25)}),
              0.25 * std::hypot(1, 0.25 / 6), 1e-8);
  EXPECT_NEAR(bound_of(plate, {Vec3(1, 1, -2), Vec3(1, 7, -2), Vec3(7, 1, -2)}), 2, 1e-12);
  EXPECT_LT(bound_of(plate, {plate.V.row(9), plate.V.row(10), plate.V.row(17)}), 1e-12);
}

TEST(HeightBound, IsNoneWhereTheSurfaceDoesNotCoverTheTriangle) {
  const std::array<Vec3, 3> triangle = {Vec3(1, 1, 0.1), Vec3(7, 1, 0.1), Vec3(1, 7, 0.1)};
  const TriangleMesh plate = test::flat_square(8, 8);
  EXPECT_NEAR(bound_of(plate, triangle), 0.1, 1e-12);
  // It ends within the triangle.
  EXPECT_TRUE(std::isinf(bound_of(plate, {Vec3(1, 1, 0), Vec3(9, 1, 0), Vec3(1, 7, 0)})));
  // A face under the triangle is missing.
  TriangleMesh holed = plate;
  for (int f = 0; f < plate.F.rows(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (int t = 0; t < 3; ++t) middle += plate.V.row(plate.F(f, t)).transpose() / 3;
    if (std::abs(middle.x() - 3.5) > 0.5 || std::abs(middle.y() - 2.5) > 0.5) continue;
    holed.F = plate.F;
    holed.F.row(f) = plate.F.row(f == 0 ? 1 : 0);
    EXPECT_TRUE(std::isinf(bound_of(holed, triangle))) << f;
  }
  ASSERT_GT(holed.F.rows(), 0);
  // A fin stands on one of its edges.
  TriangleMesh fin = plate;
  fin.V.conservativeResize(plate.V.rows() + 1, 3);
  fin.V.bottomRows<1>() << 2.5, 2.5, 3;
  fin.F.conservativeResize(plate.F.rows() + 1, 3);
  fin.F.bottomRows<1>() << 9 * 2 + 2, 9 * 2 + 3, static_cast<int>(plate.V.rows());
  EXPECT_TRUE(std::isinf(bound_of(fin, triangle)));
  // It folds over: a vertex lies beyond its neighbours.
  TriangleMesh folded = plate;
  folded.V.row(9 * 2 + 2) += Eigen::RowVector3d(2.5, 0.2, 0.1);
  EXPECT_TRUE(std::isinf(bound_of(folded, triangle)));
  // No area, and a face that is elsewhere.
  EXPECT_TRUE(std::isinf(bound_of(plate, {Vec3(1, 1, 0), Vec3(4, 1, 0), Vec3(7, 1, 0)})));
  EXPECT_TRUE(std::isinf(HeightBound(plate)(triangle, static_cast<int>(plate.F.rows()) - 1, any)));
}

}  // namespace
}  // namespace curveups
