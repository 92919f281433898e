// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/coarsen.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/remesh.hpp"
#include "curveups/geometry/surface_deviation.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TriangleMesh scan(int n) {
  return test::grid(n, n, [](double u, double v) {
    return Vec3(60 * u, 60 * v, 6 * std::sin(7 * u) * std::cos(6 * v));
  });
}

TEST(Coarsen, LeavesASoundMeshOfFewFaces) {
  const TriangleMesh fine = scan(200);  // 0.3 mm
  std::vector<char> kept(fine.V.rows(), 0);
  const int middle = 201 * 100 + 100;
  kept[middle] = 1;
  const UsedPart coarse = coarsen(fine, 1.5, kept);
  EXPECT_LT(coarse.mesh.F.rows(), fine.F.rows() / 6);
  EXPECT_TRUE(check_mesh(coarse.mesh, 7, false).empty());
  EXPECT_LT(surface_deviation(coarse.mesh, fine).hausdorff, 0.08);
  const MeshTopology topology = build_topology(coarse.mesh.F, coarse.mesh.V.rows());
  EXPECT_EQ(boundary_loops(topology).size(), 1u);
  EXPECT_EQ(boundary_loops(topology)[0].size(), 800u);
  for (const MeshEdge& edge : topology.edges) {
    EXPECT_LE((coarse.mesh.V.row(edge.v[0]) - coarse.mesh.V.row(edge.v[1])).norm(), 1.5);
  }
  ASSERT_GE(coarse.number[middle], 0);
  for (int v = 0; v < fine.V.rows(); ++v) {
    if (coarse.number[v] < 0) continue;
    EXPECT_EQ(coarse.mesh.V.row(coarse.number[v]), fine.V.row(v));
  }
}

TEST(Coarsen, KeepsClosedSurfacesClosedAndCoarseOnesAsTheyAre) {
  const TriangleMesh ball = test::sphere(40, 20);
  const UsedPart coarse = coarsen(ball, 4, {});
  EXPECT_LT(coarse.mesh.F.rows(), ball.F.rows() / 3);
  const MeshTopology topology = build_topology(coarse.mesh.F, coarse.mesh.V.rows());
  EXPECT_TRUE(boundary_loops(topology).empty());
  EXPECT_EQ(handle_count(topology, 0), 0);
  EXPECT_NEAR(surface_area(coarse.mesh), surface_area(ball), 0.02 * surface_area(ball));
  EXPECT_EQ(coarsen(ball, 0.1, {}).mesh.F, ball.F);
}

TEST(Coarsen, ScansAreRemeshedOnTheirOwnSurface) {
  const TriangleMesh fine = scan(450);
  const RemeshResult result = remesh(fine, {6});
  EXPECT_LT(distances(result.mesh.V, ClosestPoints(fine)).maxCoeff(), 1e-9);
  EXPECT_NEAR(result.mean_edge, 6, 0.2);
  EXPECT_LT(result.edge_cv, 0.13);
  const double sampled = distances(fine.V, ClosestPoints(result.mesh)).maxCoeff();
  EXPECT_GE(result.chord_error, sampled);
  EXPECT_LT(result.chord_error, sampled + 0.02);
}

}  // namespace
}  // namespace curveups
