// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/registration.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

constexpr double tile = 8, noise = 0.05;

// A square of 56 mm with this height over x and y.
template <class Height>
TriangleMesh height_field(const Height& height) {
  TriangleMesh mesh = test::flat_square(7, 7 * tile);
  mesh.V.rowwise() -= Eigen::RowVector3d(3.5 * tile, 3.5 * tile, 0);
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v)
    mesh.V(v, 2) = height(mesh.V(v, 0), mesh.V(v, 1));
  return mesh;
}

TriangleMesh bent() {
  return height_field([](double x, double y) {
    return 0.012 * x * x + 0.006 * x * y + 3e-4 * x * x * x - 2e-4 * y * y * y;
  });
}

TriangleMesh pyramid() {
  TriangleMesh mesh{Points3(5, 3), Triangles(4, 3)};
  mesh.V << -28, -28, 0, 28, -28, 0, 28, 28, 0, -28, 28, 0, 0, 0, 20;
  mesh.F << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  return mesh;
}

struct Scan {
  Points3 clean, scanned;
  RigidMotion pose;  // from the scan to the surface
};

RigidMotion some_pose() {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(2.1, Vec3(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
  return {R, Vec3(120, -40, 75)};
}

// Random points of the surface whose x is below `limit`, noisy, a share of them far off.
Scan scan_of(const TriangleMesh& mesh, int count, double limit, double outliers, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  Scan scan{Points3(count, 3), Points3(count, 3), some_pose()};
  for (int i = 0; i < count;) {
    const int f = static_cast<int>(uniform(random) * static_cast<double>(mesh.F.rows()));
    double s = uniform(random), t = uniform(random);
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const Vec3 a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)),
               c = mesh.V.row(mesh.F(f, 2));
    const Vec3 at = a + s * (b - a) + t * (c - a);
    if (at.x() > limit) continue;
    const double size = uniform(random) < outliers ? 10 : noise;
    const Vec3 error = size * Vec3(normal(random), normal(random), normal(random));
    scan.clean.row(i) = at.transpose();
    scan.scanned.row(i++) = scan.pose.to_own(at + error).transpose();
  }
  return scan;
}

// Largest distance between where the scan's clean points are laid and where they belong.
double largest_error(const Scan& scan, const RigidMotion& pose) {
  double most = 0;
  for (Eigen::Index i = 0; i < scan.clean.rows(); ++i) {
    const Vec3 at = scan.clean.row(i);
    most = std::max(most, (pose(scan.pose.to_own(at)) - at).norm());
  }
  return most;
}

TEST(Registration, FindsThePoseOfAScanWithNoiseOutliersAndAMissingPart) {
  const Scan scan = scan_of(bent(), 2000, 14, 0.1, 1);
  const Registration found = register_scan(scan.scanned, bent(), tile);
  EXPECT_LT(largest_error(scan, found.pose), 0.05);
  EXPECT_NEAR(found.noise, noise, 0.2 * noise);
  EXPECT_EQ(found.other_turns, 0);
  EXPECT_NEAR(found.pose.R.determinant(), 1, 1e-12);
}

// (J^T J)^-1 of the distances to the surface, whose gradients are its normals.
TEST(Registration, DeviationsOfAScanAreThoseOfLeastSquares) {
  const Scan scan = scan_of(bent(), 2000, 1e9, 0, 2);
  const Registration found = register_scan(scan.scanned, bent(), tile);
  const ClosestPoints surface(bent());
  Vec3 middle = Vec3::Zero();
  for (Eigen::Index i = 0; i < scan.clean.rows(); ++i) middle += scan.clean.row(i) / 2000;
  Eigen::Matrix<double, 6, 6> product = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index i = 0; i < scan.clean.rows(); ++i) {
    const Vec3 at = scan.clean.row(i), normal = surface.normal(surface(at).face);
    Eigen::Matrix<double, 6, 1> row;
    row << (at - middle).cross(normal), normal;
    product += row * row.transpose();
  }
  const Eigen::Matrix<double, 6, 1> expected = noise * product.inverse().diagonal().cwiseSqrt();
  for (int k = 0; k < 3; ++k) {  // Tukey's loss weighs normal noise by nine tenths
    EXPECT_NEAR(found.rotation_deviation[k], expected[k], 0.12 * expected[k]);
    EXPECT_NEAR(found.translation_deviation[k], expected[3 + k], 0.12 * expected[3 + k]);
  }
}

TEST(Registration, CountsTheTurnsOfASymmetricShape) {
  const Scan scan = scan_of(pyramid(), 2000, 1e9, 0.02, 3);
  const Registration found = register_scan(scan.scanned, pyramid(), tile);
  EXPECT_EQ(found.other_turns, 3);
  const ClosestPoints surface(pyramid());
  for (Eigen::Index i = 0; i < scan.clean.rows(); ++i) {
    const Vec3 laid = found.pose(scan.pose.to_own(scan.clean.row(i)));
    EXPECT_LT(surface(laid).distance, noise);
  }
}

TEST(Registration, HasNoDeviationsWhereAScanCanSlide) {
  const TriangleMesh square = height_field([](double, double) { return 0.0; });
  const Scan scan = scan_of(square, 500, 1e9, 0, 4);
  std::vector<int> inner;
  for (int i = 0; i < 500; ++i) {
    if (scan.clean.row(i).head<2>().cwiseAbs().maxCoeff() < 15) inner.push_back(i);
  }
  Points3 points(inner.size(), 3);
  for (std::size_t i = 0; i < inner.size(); ++i) points.row(i) = scan.scanned.row(inner[i]);
  const Registration found = register_scan(points, square, tile);
  EXPECT_TRUE(std::isnan(found.translation_deviation.x()));
  EXPECT_TRUE(std::isnan(found.rotation_deviation.z()));
}

TEST(Registration, MarkersFindTheirPoseThoughSomeAreFarOff) {
  const Scan scan = scan_of(bent(), 60, 1e9, 0.2, 6);
  const Registration found = register_markers(scan.scanned, scan.clean);
  EXPECT_LT(largest_error(scan, found.pose), 0.05);
  EXPECT_GT(found.loss_scale, 2 * noise);
  EXPECT_LT(found.loss_scale, 10 * noise);
}

}  // namespace
}  // namespace curveups
