// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

std::vector<char> edges_where(const TriangleMesh& mesh, const MeshTopology& topology,
                              bool (*chosen)(const Vec3& a, const Vec3& b)) {
  std::vector<char> cut;
  for (const MeshEdge& edge : topology.edges) {
    cut.push_back(chosen(mesh.V.row(edge.v[0]), mesh.V.row(edge.v[1])));
  }
  return cut;
}

void expect_same_corners(const TriangleMesh& mesh, const CutMesh& open) {
  ASSERT_EQ(open.mesh.F.rows(), mesh.F.rows());
  ASSERT_EQ(static_cast<int>(open.original.size()), open.mesh.V.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) {
      EXPECT_EQ(open.original[open.mesh.F(f, t)], mesh.F(f, t));
      EXPECT_EQ(open.mesh.V.row(open.mesh.F(f, t)), mesh.V.row(mesh.F(f, t)));
    }
  }
}

TEST(CutMesh, NothingCutChangesNothing) {
  const TriangleMesh mesh = test::half_sphere(4, 10);
  const CutMesh open = cut_open(mesh, build_topology(mesh.F), {});
  EXPECT_EQ(open.mesh.F, mesh.F);
  EXPECT_EQ(open.mesh.V, mesh.V);
}

TEST(CutMesh, SlitKeepsItsInnerTip) {
  const TriangleMesh mesh = test::flat_square(4, 4);
  const MeshTopology topology = build_topology(mesh.F);
  const auto cut = edges_where(mesh, topology, [](const Vec3& a, const Vec3& b) {
    return a.y() == 2 && b.y() == 2 && a.x() <= 2 && b.x() <= 2;
  });
  ASSERT_EQ(std::count(cut.begin(), cut.end(), 1), 2);
  const CutMesh open = cut_open(mesh, topology, cut);
  expect_same_corners(mesh, open);
  EXPECT_EQ(open.mesh.V.rows(), mesh.V.rows() + 2);  // the start on the boundary and one inside
  const auto loops = boundary_loops(build_topology(open.mesh.F));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 16u + 4u);
}

TEST(CutMesh, CutThroughSplitsInTwo) {
  const TriangleMesh mesh = test::flat_square(4, 4);
  const MeshTopology topology = build_topology(mesh.F);
  const CutMesh open =
      cut_open(mesh, topology, edges_where(mesh, topology, [](const Vec3& a, const Vec3& b) {
                 return a.y() == 2 && b.y() == 2;
               }));
  expect_same_corners(mesh, open);
  EXPECT_EQ(open.mesh.V.rows(), mesh.V.rows() + 5);
  const MeshTopology pieces = build_topology(open.mesh.F);
  const std::vector<int> component = face_components(pieces, {});
  EXPECT_EQ(*std::max_element(component.begin(), component.end()), 1);
  EXPECT_EQ(boundary_loops(pieces).size(), 2u);
}

TEST(CutMesh, ClosedSphereOpensToADisc) {
  const TriangleMesh mesh = test::sphere(4, 10);
  const MeshTopology topology = build_topology(mesh.F);
  ASSERT_TRUE(boundary_loops(topology).empty());
  // From pole to pole along half a great circle.
  const auto cut = edges_where(mesh, topology, [](const Vec3& a, const Vec3& b) {
    return std::abs(a.y()) < 1e-9 && std::abs(b.y()) < 1e-9 && a.x() > -1e-9 && b.x() > -1e-9;
  });
  const int length = static_cast<int>(std::count(cut.begin(), cut.end(), 1));
  ASSERT_EQ(length, 8);
  const CutMesh open = cut_open(mesh, topology, cut);
  expect_same_corners(mesh, open);
  EXPECT_EQ(open.mesh.V.rows(), mesh.V.rows() + length - 1);
  const auto loops = boundary_loops(build_topology(open.mesh.F));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(static_cast<int>(loops[0].size()), 2 * length);
}

TEST(CutMesh, SplitsAVertexInWhichTheBoundaryTouchesItself) {
  TriangleMesh mesh;
  mesh.V.resize(5, 3);
  mesh.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0;
  mesh.F.resize(2, 3);
  mesh.F << 0, 1, 2, 0, 3, 4;
  const MeshTopology topology = build_topology(mesh.F);
  EXPECT_THROW(boundary_loops(topology), TopologyError);
  const CutMesh open = cut_open(mesh, topology, {});
  EXPECT_EQ(open.mesh.V.rows(), 6);
  EXPECT_EQ(open.mesh.F(0, 0), 0);
  EXPECT_EQ(open.mesh.F(1, 0), 5);
  EXPECT_EQ(boundary_loops(build_topology(open.mesh.F)).size(), 2u);
}

}  // namespace
}  // namespace curveups
