// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_graph.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

std::vector<char> flags(const MeshTopology& topology, const Edges& edges) {
  std::set<std::pair<int, int>> pairs;
  for (int e = 0; e < edges.rows(); ++e) pairs.insert(std::minmax(edges(e, 0), edges(e, 1)));
  std::vector<char> out(topology.edges.size());
  for (std::size_t e = 0; e < out.size(); ++e) {
    out[e] = pairs.count(std::minmax(topology.edges[e].v[0], topology.edges[e].v[1])) > 0;
  }
  return out;
}

struct Opened {
  int pieces, loops, handles, cuts;
};

// Mesh after its opening cuts; every cut must be an interior edge of it.
Opened opened(const TriangleMesh& mesh, const Edges& given = Edges(0, 2)) {
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<char> before = flags(topology, given);
  const Edges cuts = opening_cuts(mesh, topology, before);
  std::vector<char> cut = flags(topology, cuts);
  EXPECT_EQ(std::count(cut.begin(), cut.end(), 1), cuts.rows());
  Opened out{0, 0, 0, static_cast<int>(cuts.rows())};
  for (std::size_t e = 0; e < cut.size(); ++e) {
    EXPECT_FALSE(cut[e] && topology.edges[e].boundary());
    EXPECT_FALSE(cut[e] && before[e]);
    cut[e] = cut[e] || before[e];
  }
  for (const MeshPiece& piece : cut_into_pieces(mesh, topology, cut)) {
    const MeshTopology own = build_topology(piece.mesh.F);
    const int loops = static_cast<int>(boundary_loops(own).size());
    ++out.pieces;
    out.loops += loops;
    out.handles += handle_count(own, loops);
    EXPECT_TRUE(conformal_map(piece.mesh).allFinite());
  }
  return out;
}

// A torus without some faces.
TriangleMesh torus(int around, int along, int holes = 0) {
  TriangleMesh mesh = test::torus(around, along);
  for (int h = 0; h < holes; ++h) {
    const Eigen::Index rest = mesh.F.rows() - 1, gone = h * (mesh.F.rows() / 3);
    mesh.F.row(gone) = mesh.F.row(rest);
    mesh.F.conservativeResize(rest, 3);
  }
  return mesh;
}

// Two tori joined by a bridge of the boundary of a face each: genus 2.
TriangleMesh double_torus() {
  const TriangleMesh one = torus(12, 8);
  const int count = static_cast<int>(one.V.rows()), faces = static_cast<int>(one.F.rows());
  TriangleMesh mesh;
  mesh.V.resize(2 * count, 3);
  mesh.V << one.V, one.V;
  // The second is the first one's mirror image behind the plane x = 60.
  for (int v = 0; v < count; ++v) mesh.V(count + v, 0) = 120 - mesh.V(v, 0);
  mesh.F.resize(2 * faces + 4, 3);
  const Eigen::RowVector3i left = one.F.row(0),
                           right(left[0] + count, left[1] + count, left[2] + count);
  int f = 0;
  for (int i = 1; i < faces; ++i) {
    mesh.F.row(f++) = one.F.row(i);
    mesh.F.row(f++) << one.F(i, 0) + count, one.F(i, 2) + count, one.F(i, 1) + count;
  }
  for (int t = 0; t < 3; ++t) {
    const int a = left[t], b = left[next3(t)], c = right[t], d = right[next3(t)];
    mesh.F.row(f++) << a, b, d;
    mesh.F.row(f++) << a, d, c;
  }
  return mesh;
}

TEST(OpeningCuts, OpenSurfacesNeedNone) {
  EXPECT_EQ(opened(test::half_sphere(4, 10)).cuts, 0);
  const Opened tube = opened(test::tube(8, 5, 10, 30));  // a hole may stay
  EXPECT_EQ(tube.cuts, 0);
  EXPECT_EQ(tube.loops, 2);
}

TEST(OpeningCuts, AClosedSphereGetsASlitFromEndToEnd) {
  const TriangleMesh mesh = test::sphere(6, 10);
  const Opened disc = opened(mesh);
  EXPECT_EQ(disc.pieces, 1);
  EXPECT_EQ(disc.loops, 1);
  EXPECT_EQ(disc.handles, 0);
  const MeshTopology topology = build_topology(mesh.F);
  const Edges cuts = opening_cuts(mesh, topology, {});
  double length = 0;
  for (int e = 0; e < cuts.rows(); ++e) {
    length += (mesh.V.row(cuts(e, 0)) - mesh.V.row(cuts(e, 1))).norm();
  }
  EXPECT_GT(length, 0.95 * M_PI * 10);
  EXPECT_LT(length, 1.3 * M_PI * 10);
}

TEST(OpeningCuts, TheSmallestClosedSurfaceOpens) {
  TriangleMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
  mesh.F.resize(4, 3);
  mesh.F << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  const Opened disc = opened(mesh);
  EXPECT_EQ(disc.cuts, 2);
  EXPECT_EQ(disc.loops, 1);
  EXPECT_EQ(disc.handles, 0);
}

TEST(OpeningCuts, HandlesAreCutAndNothingFallsApart) {
  for (const TriangleMesh& mesh :
       {torus(14, 9), torus(14, 9, 1), torus(14, 9, 3), double_torus()}) {
    const Opened flat = opened(mesh);
    EXPECT_EQ(flat.pieces, 1);
    EXPECT_GE(flat.loops, 1);
    EXPECT_EQ(flat.handles, 0);
    EXPECT_GT(flat.cuts, 0);
  }
}

TEST(OpeningCuts, GivenCutsCount) {
  // A ring cut through once is a tube: no handle is left, and nothing to do.
  const TriangleMesh mesh = torus(14, 9);
  Edges round(9, 2);
  for (int row = 0; row < 9; ++row) round.row(row) << row * 15, (row + 1) % 9 * 15;
  const Opened tube = opened(mesh, round);
  EXPECT_EQ(tube.cuts, 0);
  EXPECT_EQ(tube.loops, 2);
  // A slit that is too short to open the handle.
  const Opened slit = opened(mesh, round.topRows(4));
  EXPECT_GT(slit.cuts, 0);
  EXPECT_EQ(slit.handles, 0);
  EXPECT_EQ(slit.pieces, 1);
}

TEST(OpeningCuts, EveryClosedComponentIsOpened) {
  const TriangleMesh one = test::sphere(3, 10);
  TriangleMesh two;
  two.V.resize(2 * one.V.rows(), 3);
  two.V << one.V, one.V.rowwise() + Eigen::RowVector3d(50, 0, 0);
  two.F.resize(2 * one.F.rows(), 3);
  two.F << one.F, one.F.array() + static_cast<int>(one.V.rows());
  const Opened discs = opened(two);
  EXPECT_EQ(discs.pieces, 2);
  EXPECT_EQ(discs.loops, 2);
}

}  // namespace
}  // namespace curveups
