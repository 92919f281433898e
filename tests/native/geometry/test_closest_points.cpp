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

TEST(ClosestPoints, DeviationOfConcentricSpheres) {
  const TriangleMesh inner = test::half_sphere(24, 20), outer = test::half_sphere(24, 21);
  const Deviation d = surface_deviation(inner, outer);
  EXPECT_NEAR(d.mean, 1, 0.05);
  EXPECT_NEAR(d.max, 1, 0.1);
  EXPECT_GE(d.hausdorff, d.max);
  const Deviation none = surface_deviation(inner, inner);
  EXPECT_LT(none.hausdorff, 1e-9);
}

TEST(ClosestPoints, HausdorffSeesWhatIsMissing) {
  const TriangleMesh whole = test::flat_square(8, 8);
  TriangleMesh part = whole;
  part.F.conservativeResize(64, 3);  // the lower half
  const Deviation d = surface_deviation(part, whole);
  EXPECT_LT(d.max, 1e-12);
  EXPECT_NEAR(d.hausdorff, 4, 1e-9);
}

TEST(ClosestPoints, SurfacesThatAreNoManifoldsAreComparedToo) {
  const TriangleMesh plate = test::flat_square(4, 8);
  TriangleMesh fin = plate;  // on an inner edge
  const int top = static_cast<int>(plate.V.rows());
  fin.V.conservativeResize(top + 1, 3);
  fin.V.row(top) << 4, 4, 1.5;
  fin.F.conservativeResize(fin.F.rows() + 1, 3);
  fin.F.bottomRows(1) << 5 * 2 + 2, 5 * 2 + 3, top;
  const Deviation d = surface_deviation(plate, fin);
  EXPECT_LT(d.max, 1e-12);
  EXPECT_NEAR(d.hausdorff, 1.5, 1e-9);
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
