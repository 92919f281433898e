// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/unite_meshes.hpp"

namespace curveups {
namespace {

TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh out{Points3(8, 3), Triangles(12, 3)};
  for (int v = 0; v < 8; ++v) {
    for (int k = 0; k < 3; ++k) out.V(v, k) = v >> k & 1 ? high[k] : low[k];
  }
  out.F << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6,
      1, 3, 5, 3, 7, 5;
  return out;
}

double volume(const TriangleMesh& mesh) {
  double six = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    Eigen::Matrix3d corners;
    for (int t = 0; t < 3; ++t) corners.row(t) = mesh.V.row(mesh.F(f, t));
    six += corners.determinant();
  }
  return six / 6;
}

int shells(const TriangleMesh& mesh) {
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<int> of = face_components(topology, {});
  return of.empty() ? 0 : *std::max_element(of.begin(), of.end()) + 1;
}

void expect_closed(const TriangleMesh& mesh) {
  for (const MeshEdge& edge : build_topology(mesh.F).edges) {
    EXPECT_FALSE(edge.boundary());
  }
}

TriangleMesh together(const std::vector<TriangleMesh>& solids) {
  TriangleMesh out{Points3(0, 3), Triangles(0, 3)};
  for (const TriangleMesh& solid : solids) {
    const auto points = out.V.rows(), faces = out.F.rows();
    out.V.conservativeResize(points + solid.V.rows(), 3);
    out.V.bottomRows(solid.V.rows()) = solid.V;
    out.F.conservativeResize(faces + solid.F.rows(), 3);
    out.F.bottomRows(solid.F.rows()) = solid.F.array() + static_cast<int>(points);
  }
  return out;
}

TEST(UniteMeshes, ChainOfTilesAndBridgesIsOneShellInOrder) {
  // Five blocks with a gap of 1 between them; bridges reach 0.25 into each.
  std::vector<TriangleMesh> blocks, bridges;
  for (int k = 0; k < 5; ++k) blocks.push_back(box({5. * k, 0, 0}, {5. * k + 4, 4, 3}));
  for (int k = 0; k < 4; ++k) {
    bridges.push_back(box({5 * k + 3.75, 1, 1}, {5 * k + 5.25, 2, 2}));
    bridges.push_back(box({5 * k + 3.75, 2.5, 1.25}, {5 * k + 5.25, 3, 1.75}));
  }
  const TriangleMesh united = unite_meshes(together(blocks), together(bridges));
  expect_closed(united);
  EXPECT_EQ(shells(united), 1);
  EXPECT_NEAR(volume(united), 5 * 4 * 4 * 3 + 4 * (1 + 0.25), 1e-9);
  // Corefinement's own order depends on addresses in memory.
  std::vector<std::unique_ptr<std::array<char, 4096>>> elsewhere;
  for (int k = 0; k < 100; ++k) elsewhere.push_back(std::make_unique<std::array<char, 4096>>());
  const TriangleMesh again = unite_meshes(together(blocks), together(bridges));
  EXPECT_EQ(again.V, united.V);
  EXPECT_EQ(again.F, united.F);
  for (Eigen::Index f = 0; f < united.F.rows(); ++f) {
    EXPECT_EQ(united.F.row(f).minCoeff(), united.F(f, 0));
  }
}

TEST(UniteMeshes, KeepsWhatTouchesNothing) {
  const TriangleMesh a = box({0, 0, 0}, {1, 1, 1}), b = box({2, 0, 0}, {3, 1, 1});
  const TriangleMesh none{Points3(0, 3), Triangles(0, 3)};
  for (const TriangleMesh& united : {unite_meshes(a, b), unite_meshes(together({a, b}), none)}) {
    EXPECT_EQ(united.F.rows(), 24);
    EXPECT_EQ(shells(united), 2);
    EXPECT_NEAR(volume(united), 2, 1e-12);
  }
}

TEST(UniteMeshes, FacesInOnePlaneAreNoObstacle) {
  const TriangleMesh united = unite_meshes(box({0, 0, 0}, {2, 2, 2}), box({1, 0, 0}, {3, 2, 2}));
  expect_closed(united);
  EXPECT_EQ(shells(united), 1);
  EXPECT_NEAR(volume(united), 12, 1e-9);
}

TEST(UniteMeshes, OpenSolidsAreRefused) {
  TriangleMesh open = box({0, 0, 0}, {2, 2, 2});
  open.F.conservativeResize(11, 3);
  EXPECT_THROW(unite_meshes(open, box({1, 1, 1}, {3, 3, 3})), SolverFailure);
}

}  // namespace
}  // namespace curveups
