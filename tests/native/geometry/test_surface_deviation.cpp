// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/surface_deviation.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TEST(SurfaceDeviation, DeviationOfConcentricSpheres) {
  const TriangleMesh inner = test::half_sphere(24, 20), outer = test::half_sphere(24, 21);
  const Deviation d = surface_deviation(inner, outer);
  EXPECT_NEAR(d.mean, 1, 0.05);
  EXPECT_NEAR(d.max, 1, 0.1);
  EXPECT_GE(d.hausdorff, d.max);
  const Deviation none = surface_deviation(inner, inner);
  EXPECT_LT(none.hausdorff, 1e-9);
}

TEST(SurfaceDeviation, HausdorffSeesWhatIsMissing) {
  const TriangleMesh whole = test::flat_square(8, 8);
  TriangleMesh part = whole;
  part.F.conservativeResize(64, 3);  // the lower half
  const Deviation d = surface_deviation(part, whole);
  EXPECT_LT(d.max, 1e-12);
  EXPECT_NEAR(d.hausdorff, 4, 1e-9);
}

TEST(SurfaceDeviation, SurfacesThatAreNoManifoldsAreComparedToo) {
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

// The largest distance over a fine grid of every face: short by half the grid's step at most.
double by_brute_force(const TriangleMesh& mesh, const TriangleMesh& target, int parts) {
  const ClosestPoints closest(target);
  double largest = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int i = 0; i <= parts; ++i) {
      for (int j = 0; i + j <= parts; ++j) {
        const Vec3 at = (i * mesh.V.row(mesh.F(f, 0)) + j * mesh.V.row(mesh.F(f, 1)) +
                         (parts - i - j) * mesh.V.row(mesh.F(f, 2))) /
                        parts;
        largest = std::max(largest, closest(at).distance);
      }
    }
  }
  return largest;
}

TEST(SurfaceDeviation, TheLargestDistanceIsThatOfSamples) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int beyond_vertices = 0;
  for (int pair = 0; pair < 20; ++pair) {
    // A coarse and a fine surface, one bent, moved, crumpled or with a part missing.
    TriangleMesh mesh = test::flat_square(2 + pair % 3, 6), target = test::flat_square(9, 6);
    for (int v = 0; v < mesh.V.rows(); ++v) mesh.V(v, 2) += 0.5 * uniform(random);
    for (int v = 0; v < target.V.rows(); ++v) {
      const Vec3 p = target.V.row(v);
      target.V(v, 2) += 0.04 * (pair % 5) * p.x() * p.y() / 6 + 0.1 * uniform(random);
    }
    if (pair % 4 == 3) {
      Triangles rest(target.F.rows() - 12, 3);
      rest << target.F.topRows(70), target.F.bottomRows(target.F.rows() - 82);
      target.F = rest;
    }
    const ClosestPoints closest(target);
    const double largest = largest_distance(mesh, target);
    const int parts = 90;
    const double brute = by_brute_force(mesh, target, parts);
    EXPECT_LE(largest, brute + 3.0 * 1.5 / parts) << pair;
    const double step = sample_step * std::max(mean_edge_length(mesh), mean_edge_length(target));
    EXPECT_GE(largest, brute - 2.0 / 3 * step) << pair;  // kinks lie between samples
    const Deviation d = surface_deviation(mesh, target);
    EXPECT_EQ(d.max, largest);
    EXPECT_NEAR(d.hausdorff, std::max(brute, by_brute_force(target, mesh, 30)), 0.06) << pair;
    EXPECT_LE(d.mean, d.rms);
    EXPECT_LE(d.rms, d.max);
    beyond_vertices += largest > distances(mesh.V, closest).maxCoeff() + 0.01;
  }
  EXPECT_GE(beyond_vertices, 5);  // samples at vertices are too few there
}

TEST(SurfaceDeviation, AHoleIsFoundWithinAStep) {
  // Big triangle over a plate with a slot: farthest in the slot's middle, at half its width.
  TriangleMesh plate = test::flat_square(8, 8), cover = test::flat_square(1, 8);
  Triangles rest(0, 3);
  for (int f = 0; f < plate.F.rows(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (int t = 0; t < 3; ++t) middle += plate.V.row(plate.F(f, t)).transpose() / 3;
    if (middle.x() > 1 && middle.x() < 6 && middle.y() > 2 && middle.y() < 3) continue;
    rest.conservativeResize(rest.rows() + 1, 3);
    rest.bottomRows<1>() = plate.F.row(f);
  }
  plate.F = rest;
  const Deviation d = surface_deviation(cover, plate);
  EXPECT_LE(d.max, 0.5);
  EXPECT_GT(d.max, 0.3);
  // 5 mm2 of 64 are off by 1/4 in the mean, less at the slot's ends.
  EXPECT_NEAR(d.mean, 5.0 / 64 / 4, 0.005);
}

TEST(SurfaceDeviation, MeanAndRootMeanSquareAreByArea) {
  // A tilted plate: heights 0 to 1 over the plane, mean 1/2, mean square 1/3.
  TriangleMesh plane = test::flat_square(1, 40), tilted = test::flat_square(1, 2);
  plane.V.leftCols<2>().array() -= 10;
  tilted.V.col(2) = tilted.V.col(0) / 2;
  const Deviation d = surface_deviation(tilted, plane);
  EXPECT_NEAR(d.mean, 0.5, 1e-12);
  EXPECT_NEAR(d.rms, std::sqrt(1.0 / 3), 0.01);
  EXPECT_NEAR(d.max, 1, 1e-12);
}

}  // namespace
}  // namespace curveups
