// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TEST(ClosestPoints, FindsFacesEdgesAndVertices) {
  const TriangleMesh mesh = test::flat_square(4, 4);
  const ClosestPoints closest(mesh);
  EXPECT_LT((closest(Vec3(1.3, 2.2, 5)).point - Vec3(1.3, 2.2, 0)).norm(), 1e-12);
  EXPECT_NEAR(closest(Vec3(-3, 1, 4)).distance, 5, 1e-12);
  EXPECT_LT((closest(Vec3(-1, -1, 0)).point).norm(), 1e-12);
  const ClosestPoint p = closest(Vec3(0.4, 0.2, -1));
  EXPECT_EQ(p.face, 0);
}

TEST(ClosestPoints, RefusesEmptyAndInfinite) {
  EXPECT_THROW(ClosestPoints(TriangleMesh{Points3(0, 3), Triangles(0, 3)}), InvalidInput);
  TriangleMesh mesh = test::flat_square(1, 1);
  mesh.V(2, 1) = std::nan("");
  EXPECT_THROW(ClosestPoints{mesh}, InvalidInput);
  TriangleMesh beyond = test::flat_square(2, 2);
  beyond.F(0, 1) = static_cast<int>(beyond.V.rows());
  EXPECT_THROW(ClosestPoints{beyond}, InvalidInput);
}

}  // namespace
}  // namespace curveups
