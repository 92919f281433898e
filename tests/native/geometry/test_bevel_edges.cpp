// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/bevel_edges.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

// A roof, 60 x 60 mm in plan, whose sides turn by `angle` degrees along the y axis.
TriangleMesh roof(double angle, int columns = 2, int rows = 1) {
  const double slope = std::tan(0.5 * angle * degree);
  return test::grid(columns, rows, [&](double u, double v) {
    return Vec3(60 * u - 30, 60 * v, -slope * std::abs(60 * u - 30));
  });
}

TriangleMesh noisy(TriangleMesh mesh, double deviation) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, deviation);
  for (Eigen::Index k = 0; k < mesh.V.size(); ++k) mesh.V.data()[k] += noise(random);
  return mesh;
}

double largest_turn(const TriangleMesh& mesh) {
  const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
  double most = 0;
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) continue;
    const Vec3 a = face_area_vector(mesh, edge.face[0]), b = face_area_vector(mesh, edge.face[1]);
    most = std::max(most, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return most;
}

TEST(BevelEdges, AnEdgeOfNinetyDegreesBecomesThreeOfThirty) {
  const TriangleMesh given = roof(90);
  const BevelledMesh made = bevel_edges(given, {});
  EXPECT_NEAR(made.length, 60, 1e-9);
  EXPECT_NEAR(largest_turn(made.mesh) / degree, 30, 0.05);
  // Rims, and the edge, which is as deep everywhere: 4.9 sin 45 (1 - tan 15 / tan 45).
  double length = 0;
  for (int e = 0; e < made.lines.rows(); ++e) {
    const Vec3 a = made.mesh.V.row(made.lines(e, 0)), b = made.mesh.V.row(made.lines(e, 1));
    length += (b - a).norm();
    EXPECT_NEAR(a.x(), b.x(), 1e-4);
    EXPECT_TRUE(std::abs(a.x()) < 1e-4 || std::abs(std::abs(a.x()) - 4.9 * std::sqrt(0.5)) < 1e-4);
    if (std::abs(a.x()) < 1e-4) {
      EXPECT_NEAR(a.z(), -2.53, 0.01);
    }
  }
  EXPECT_NEAR(length, 3 * 60, 1e-3);
  EXPECT_NEAR(made.mesh.V.col(1).minCoeff(), 0, 1e-9);  // the border stays in its plane
  EXPECT_NEAR(made.mesh.V.col(1).maxCoeff(), 60, 1e-9);
  EXPECT_EQ(made.mesh.V.topRows(1), given.V.topRows(1));
  EXPECT_LE(distances(made.mesh.V, ClosestPoints(given)).maxCoeff(), 2.53);
}

TEST(BevelEdges, AnEdgeThatTilesBendRoundIsKept) {
  const TriangleMesh given = roof(60, 4, 5);
  const BevelledMesh made = bevel_edges(given, {});
  EXPECT_EQ(made.mesh.V, given.V);
  EXPECT_EQ(made.mesh.F, given.F);
  EXPECT_EQ(made.length, 0);
  EXPECT_EQ(made.lines.rows(), 5);
  for (Eigen::Index k = 0; k < made.lines.size(); ++k) {
    EXPECT_NEAR(given.V(made.lines.data()[k], 0), 0, 1e-9);
  }
}

TEST(BevelEdges, FacetsOfAScanAreNoEdges) {
  for (const TriangleMesh& given :
       {noisy(test::flat_square(60, 40), 0.15), noisy(test::dome(40, 1, 30), 0.15)}) {
    ASSERT_GT(largest_turn(given), 1.2);
    const BevelledMesh made = bevel_edges(given, {});
    EXPECT_EQ(made.mesh.V, given.V);
    EXPECT_EQ(made.length, 0);
    EXPECT_EQ(made.lines.rows(), 0);
  }
  // Where there is one, it is found among them.
  EXPECT_NEAR(bevel_edges(noisy(roof(90, 60, 60), 0.05), {}).length, 60, 6);
}

TEST(BevelEdges, WhatIsNoMeshOrNoLengthIsRefused) {
  const TriangleMesh given = roof(90);
  EXPECT_THROW(bevel_edges({Points3(0, 3), Triangles(0, 3)}, {}), InvalidInput);
  for (double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(bevel_edges(given, {bad}), InvalidInput);
  }
}

}  // namespace
}  // namespace curveups
