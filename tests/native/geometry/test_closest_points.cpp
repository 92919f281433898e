// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace curveups
