// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/follow_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/remesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

constexpr double L = 7, degree = M_PI / 180;

std::ptrdiff_t kept_numbers(const FollowedMesh& followed) {
  std::ptrdiff_t kept = 0;
  for (std::size_t i = 0; i < followed.tile_from.size(); ++i) {
    kept += followed.tile_from[i] == static_cast<int>(i);
  }
  return kept;
}

// A square of 120 mm with a round hole, bent a little.
TriangleMesh plate(double x, double radius, int holes = 1) {
  const int cells = 60;
  TriangleMesh mesh = test::flat_square(cells, 120);
  mesh.V.rowwise() -= 0.5 * (mesh.V.colwise().minCoeff() + mesh.V.colwise().maxCoeff()).eval();
  const auto distance = [&](const Eigen::RowVector3d& p, int hole) {
    return (p - Eigen::RowVector3d(x + (hole == 0 ? 0 : -40), hole == 0 ? 0 : 30, 0)).norm();
  };
  std::vector<int> rows;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    bool outside = true;
    for (int v : mesh.F.row(f)) {
      for (int hole = 0; hole < holes; ++hole) {
        outside = outside && distance(mesh.V.row(v), hole) > radius;
      }
    }
    if (outside) rows.push_back(f);
  }
  UsedPart part = used_part(mesh.V, mesh.F(rows, Eigen::all));
  const MeshTopology topology = build_topology(part.mesh.F);
  for (const std::vector<int>& loop : boundary_loops(topology)) {
    for (int v : loop) {  // onto the circle
      for (int hole = 0; hole < holes; ++hole) {
        if (distance(part.mesh.V.row(v), hole) > radius + 5) continue;
        const Eigen::RowVector3d c(x + (hole == 0 ? 0 : -40), hole == 0 ? 0 : 30, 0);
        part.mesh.V.row(v) = c + radius * (part.mesh.V.row(v) - c).normalized();
      }
    }
  }
  for (int v = 0; v < part.mesh.V.rows(); ++v) {
    part.mesh.V(v, 2) = -0.002 * part.mesh.V.row(v).squaredNorm();
  }
  return part.mesh;
}

TEST(FollowMesh, KeepsAllTilesOfTheSameSurface) {
  for (const char* name : {"half-sphere", "mask"}) {
    const TriangleMesh surface = builtin_target(name, 0.05);
    const TriangleMesh tiles = remesh(surface, {L}).mesh;
    const FollowedMesh followed = follow_mesh(tiles, surface, {L});
    ASSERT_EQ(followed.obstacle, "") << name;
    EXPECT_EQ(followed.mesh.F, tiles.F) << name;
    EXPECT_EQ(kept_numbers(followed), tiles.F.rows()) << name;
    EXPECT_LT((followed.mesh.V - tiles.V).rowwise().norm().maxCoeff(), 0.05 * L) << name;
  }
}

TEST(FollowMesh, StretchesADome) {
  const TriangleMesh surface = builtin_target("half-sphere", 0.05);
  const TriangleMesh tiles = remesh(surface, {L}).mesh;
  TriangleMesh higher = surface;
  higher.V.col(2) *= 1.1;
  const FollowedMesh followed = follow_mesh(tiles, higher, {L});
  ASSERT_EQ(followed.obstacle, "");
  EXPECT_GE(kept_numbers(followed), 0.95 * tiles.F.rows());
  EXPECT_LT(distances(followed.mesh.V, ClosestPoints(higher)).maxCoeff(), 1e-9);
  EXPECT_LT(followed.chord_error, 0.1 * L);
  EXPECT_TRUE(check_mesh(followed.mesh, L, false).empty());
  higher.V *= 1.3;
  EXPECT_EQ(follow_mesh(tiles, higher, {L}).obstacle, "edges");
}

TEST(FollowMesh, GoesAlongWithAHoleThatMoves) {
  const TriangleMesh tiles = remesh(plate(0, 18), {L}).mesh;
  const TriangleMesh moved = plate(6, 18);
  const FollowedMesh followed = follow_mesh(tiles, moved, {L});
  ASSERT_EQ(followed.obstacle, "");
  EXPECT_GE(kept_numbers(followed), 0.9 * tiles.F.rows());
  EXPECT_TRUE(check_mesh(followed.mesh, L, false).empty());
  EXPECT_LT(std::abs(surface_area(followed.mesh) / surface_area(moved) - 1), 0.01);
  // Corners of the border stay vertices.
  for (double x : {-60.0, 60.0}) {
    const Eigen::RowVector3d corner(x, x, -0.002 * 2 * x * x);
    EXPECT_LT((followed.mesh.V.rowwise() - corner).rowwise().norm().minCoeff(), 1e-9);
  }
}

// Two surfaces as parts of one.
TriangleMesh both(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh out{Points3(a.V.rows() + b.V.rows(), 3), Triangles(a.F.rows() + b.F.rows(), 3)};
  out.V << a.V, b.V;
  out.F << a.F, b.F.array() + static_cast<int>(a.V.rows());
  return out;
}

TEST(FollowMesh, SmoothsAnOpenPartBesideAClosedOneAsByItself) {
  TriangleMesh ball = test::sphere(12, 30);
  ball.V.col(2).array() += 60;
  const TriangleMesh plate_tiles = remesh(plate(0, 18), {L}).mesh, moved = plate(6, 18);
  const FollowedMesh alone = follow_mesh(plate_tiles, moved, {L});
  const FollowedMesh beside =
      follow_mesh(both(plate_tiles, remesh(ball, {L}).mesh), both(moved, ball), {L});
  ASSERT_EQ(beside.obstacle, "");
  const Eigen::Index count = plate_tiles.V.rows();
  ASSERT_EQ(alone.mesh.V.rows(), count);
  const Points3 away = beside.mesh.V.topRows(count) - alone.mesh.V;
  EXPECT_LT(away.rowwise().norm().maxCoeff(), 0.1 * L);
}

TEST(FollowMesh, InsertsAndRemovesTilesWhereASurfaceGrowsOrShrinks) {
  const auto bump = [](double height) {
    return test::grid(60, 60, [height](double u, double v) {
      const double x = 120 * u - 60, y = 120 * v - 60;
      return Vec3(x, y, height * std::exp(-(x * x + y * y) / 288));
    });
  };
  const std::pair<double, double> heights[] = {{0, 26}, {40, 0}};
  for (const auto& [before, after] : heights) {
    const TriangleMesh tiles = remesh(bump(before), {L}).mesh, changed = bump(after);
    const FollowedMesh followed = follow_mesh(tiles, changed, {L});
    ASSERT_EQ(followed.obstacle, "") << after;
    EXPECT_TRUE(check_mesh(followed.mesh, L, false).empty());
    EXPECT_EQ(after > before, followed.mesh.F.rows() > tiles.F.rows());
    EXPECT_NE(followed.mesh.F.rows(), tiles.F.rows());
    EXPECT_GT(kept_numbers(followed), 0.9 * tiles.F.rows()) << after;
    for (std::size_t i = 0; i < followed.tile_from.size(); ++i) {
      const int from = followed.tile_from[i];
      if (from < 0) continue;
      for (int t = 0; t < 3; ++t) {
        const int v = followed.mesh.F(static_cast<Eigen::Index>(i), t);
        EXPECT_EQ(followed.vertex_from[v], tiles.F(from, t));
      }
    }
    EXPECT_NEAR(surface_area(followed.mesh), surface_area(changed), 0.01 * surface_area(changed));
  }
}

TEST(FollowMesh, KeepsCreases) {
  // A roof whose ridge moves.
  const auto roof = [](double ridge) {
    TriangleMesh mesh = test::flat_square(40, 80);
    mesh.V.rowwise() -= 0.5 * (mesh.V.colwise().minCoeff() + mesh.V.colwise().maxCoeff()).eval();
    for (int v = 0; v < mesh.V.rows(); ++v) {
      const double x = mesh.V(v, 0), shifted = x < 0 ? -40 + (x + 40) / 40 * (ridge + 40)
                                                     : ridge + x / 40 * (40 - ridge);
      mesh.V(v, 0) = shifted;
      mesh.V(v, 2) = -0.6 * std::abs(shifted - ridge);
    }
    return mesh;
  };
  RemeshOptions options{L};
  options.crease_angle = 30 * degree;
  const TriangleMesh tiles = remesh(roof(0), options).mesh;
  const FollowedMesh followed = follow_mesh(tiles, roof(3), {L, 30 * degree});
  ASSERT_EQ(followed.obstacle, "");
  EXPECT_LT(followed.chord_error, 1e-6);  // no tile lies across the ridge
  EXPECT_GE(kept_numbers(followed), 0.95 * tiles.F.rows());
}

TEST(FollowMesh, RefusesByName) {
  const TriangleMesh tiles = remesh(plate(0, 18), {L}).mesh;
  EXPECT_EQ(follow_mesh(tiles, plate(0, 12, 2), {L}).obstacle, "borders");
  EXPECT_EQ(follow_mesh(tiles, test::flat_square(60, 120), {L}).obstacle, "borders");
  TriangleMesh bent = plate(0, 18);  // a crease appears
  for (int v = 0; v < bent.V.rows(); ++v) bent.V(v, 2) += std::max(0.0, bent.V(v, 0) - 30.3);
  EXPECT_EQ(follow_mesh(tiles, bent, {L, 30 * degree}).obstacle, "creases");
  EXPECT_EQ(follow_mesh(tiles, plate(0, 18), {2 * L}).obstacle, "edges");
}

}  // namespace
}  // namespace curveups
