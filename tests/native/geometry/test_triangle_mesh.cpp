// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/triangle_mesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TEST(TriangleMesh, NeighboursAnswerOneAnother) {
  const TriangleMesh mesh = test::tube(9, 4, 5, 6);
  const MeshTopology topology = build_topology(mesh.F);
  int boundary = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    boundary += edge.boundary();
    for (int k = 0; k < (edge.boundary() ? 1 : 2); ++k) {
      EXPECT_EQ(topology.edge_of(edge.face[k], edge.side[k]), static_cast<int>(e));
      EXPECT_EQ(topology.neighbour(edge.face[k], edge.side[k]), edge.face[1 - k]);
      EXPECT_EQ(mesh.F(edge.face[k], edge.side[k]), edge.v[k]);
      EXPECT_EQ(mesh.F(edge.face[k], next3(edge.side[k])), edge.v[1 - k]);
    }
  }
  EXPECT_EQ(boundary, 18);
  EXPECT_EQ(static_cast<int>(topology.edges.size()), (3 * 72 + 18) / 2);
}

TEST(TriangleMesh, LoopsRunWithTheSurfaceOnTheLeft) {
  const TriangleMesh mesh = test::flat_square(3, 3);
  const auto loops = boundary_loops(build_topology(mesh.F));
  ASSERT_EQ(loops.size(), 1u);
  ASSERT_EQ(loops[0].size(), 12u);
  double area = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const Vec3 a = mesh.V.row(loops[0][i]), b = mesh.V.row(loops[0][(i + 1) % 12]);
    EXPECT_NEAR((b - a).norm(), 1, 1e-12);
    area += 0.5 * a.cross(b).z();
  }
  EXPECT_NEAR(area, 9, 1e-12);
}

TEST(TriangleMesh, ComponentsFollowTheJoinedEdges) {
  const TriangleMesh mesh = test::flat_square(2, 2);
  const MeshTopology topology = build_topology(mesh.F);
  EXPECT_EQ(face_components(topology, {}), std::vector<int>(8, 0));
  const auto alone = face_components(topology, std::vector<char>(topology.edges.size(), 0));
  for (int f = 0; f < 8; ++f) EXPECT_EQ(alone[f], f);
}

TEST(TriangleMesh, MeasuresLengthsAndAreas) {
  TriangleMesh mesh;
  mesh.V.resize(3, 3);
  mesh.V << 1, 1, 1, 4, 1, 1, 1, 5, 1;
  mesh.F.resize(1, 3);
  mesh.F << 0, 1, 2;
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), 4);
  EXPECT_DOUBLE_EQ(surface_area(mesh), 6);
  EXPECT_DOUBLE_EQ(face_area_vector(mesh, 0).z(), 6);
}

TEST(TriangleMesh, RefusesWhatIsNoOrientedManifold) {
  Triangles F(3, 3);
  F << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  try {
    build_topology(F);
    FAIL() << "three faces at an edge were accepted";
  } catch (const TopologyError& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{2});
  }
  F.resize(2, 3);
  F << 0, 1, 2, 0, 1, 3;
  try {
    build_topology(F);
    FAIL() << "twisted faces were accepted";
  } catch (const TopologyError& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{1});
  }
  F << 0, 1, 2, 1, 1, 3;
  EXPECT_THROW(build_topology(F), TopologyError);
}

}  // namespace
}  // namespace curveups
