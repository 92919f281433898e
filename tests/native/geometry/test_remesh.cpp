// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/remesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

std::size_t loop_count(const TriangleMesh& mesh) {
  return boundary_loops(build_topology(mesh.F, mesh.V.rows())).size();
}

class RemeshBuiltin : public testing::TestWithParam<std::string> {};

TEST_P(RemeshBuiltin, IsUniform) {
  const double L = 7;
  const TriangleMesh target = builtin_target(GetParam());
  const RemeshResult result = remesh(target, {L});
  EXPECT_TRUE(check_mesh(result.mesh, L, false).empty());
  EXPECT_EQ(loop_count(result.mesh), loop_count(target));
  EXPECT_NEAR(result.mean_edge, L, 0.03 * L);
  EXPECT_NEAR(mean_edge_length(result.mesh), result.mean_edge, 1e-9);
  EXPECT_LT(result.edge_cv, 0.12);
  EXPECT_LT(result.max_distance, 0.005 * L);
  EXPECT_LT(result.sagitta, 0.08 * L);
  EXPECT_NEAR(surface_area(result.mesh), surface_area(target), 0.02 * surface_area(target));
  const MeshTopology topology = build_topology(result.mesh.F, result.mesh.V.rows());
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) continue;
    const Vec3 a = face_area_vector(result.mesh, edge.face[0]);
    const Vec3 b = face_area_vector(result.mesh, edge.face[1]);
    EXPECT_LT(std::atan2(a.cross(b).norm(), a.dot(b)), 35 * M_PI / 180);
  }
}
INSTANTIATE_TEST_SUITE_P(Targets, RemeshBuiltin,
                         testing::Values("half-sphere", "hyperboloid", "saddle", "ellipsoid-cap",
                                         "tower", "mask", "cap", "disc", "cylinder-patch"));

TEST(Remesh, KeepsCornersSmallHolesAndComponents) {
  // Two squares side by side, one without two faces in its middle: a hole much smaller than L.
  TriangleMesh mesh = test::flat_square(16, 40);
  const int half = static_cast<int>(mesh.V.rows()), faces = static_cast<int>(mesh.F.rows());
  mesh.V.conservativeResize(2 * half, 3);
  mesh.V.bottomRows(half) = mesh.V.topRows(half).rowwise() + Eigen::RowVector3d(100, 0, 0);
  Triangles F(2 * faces - 2, 3);
  F.topRows(faces) = mesh.F.array() + half;
  const int hole = 2 * (16 * 8 + 8);
  F.middleRows(faces, hole) = mesh.F.topRows(hole);
  F.bottomRows(faces - hole - 2) = mesh.F.bottomRows(faces - hole - 2);
  mesh.F = F;
  ASSERT_EQ(loop_count(mesh), 3u);
  const RemeshResult result = remesh(mesh, {5});
  EXPECT_EQ(loop_count(result.mesh), 3u);
  const ClosestPoints surface(mesh);
  for (double x : {0.0, 40.0, 100.0, 140.0}) {
    for (double y : {0.0, 40.0}) {
      EXPECT_LT((result.mesh.V.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(),
                1e-9);
    }
  }
  EXPECT_NEAR(surface_area(result.mesh), surface_area(mesh), 1);
}

TEST(Remesh, NeedlesOfACadTessellationGo) {
  // A cylinder as CAD writes it: long thin faces between two arcs.
  const TriangleMesh needles = test::grid(240, 1, [](double u, double v) {
    const double a = M_PI * u;
    return Vec3(30 * std::cos(a), 30 * std::sin(a), 60 * v);
  });
  const RemeshResult result = remesh(needles, {6});
  EXPECT_NEAR(result.mean_edge, 6, 0.18);
  EXPECT_LT(result.edge_cv, 0.12);
  EXPECT_LT(result.max_distance, 1e-6);
  EXPECT_EQ(loop_count(result.mesh), 1u);
}

TEST(Remesh, ClosedSurfaceStaysClosed) {
  const RemeshResult result = remesh(test::sphere(24, 25), {6});
  EXPECT_EQ(loop_count(result.mesh), 0u);
  EXPECT_NEAR(result.mean_edge, 6, 0.18);
  EXPECT_LT(result.edge_cv, 0.12);
}

TEST(Remesh, IsTheSameOnAnyNumberOfThreads) {
  const TriangleMesh target = builtin_target("saddle", 0.05);
  const int before = thread_count();
  set_thread_count(1);
  const RemeshResult one = remesh(target, {7});
  set_thread_count(3);
  const RemeshResult three = remesh(target, {7});
  set_thread_count(before);
  EXPECT_EQ(one.mesh.V, three.mesh.V);
  EXPECT_EQ(one.mesh.F, three.mesh.F);
  EXPECT_EQ(one.sagitta, three.sagitta);
}

TEST(Remesh, StopsAndRefuses) {
  const TriangleMesh disc = builtin_target("disc", 0.1);
  RemeshOptions options;
  options.progress = [](const std::string&, double) { return false; };
  EXPECT_THROW(remesh(disc, options), Cancelled);
  EXPECT_THROW(remesh(disc, {0}), InvalidInput);
  EXPECT_THROW(remesh(disc, {std::nan("")}), InvalidInput);
  EXPECT_THROW(remesh(disc, {0.01}), InvalidInput);
  TriangleMesh spike = disc;
  spike.V(disc.F(0, 0), 2) = 4000;
  EXPECT_THROW(remesh(spike, {7}), InvalidInput);
  TriangleMesh broken = disc;
  broken.V(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(remesh(broken, {7}), InvalidInput);
}

}  // namespace
}  // namespace curveups
