// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/divide_surface.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

struct Divided {
  SurfaceDivision division;
  std::vector<MeshPiece> pieces;
  double border = 0;  // mm
  std::vector<double> area;
};

// Divides and checks what holds of any division: pieces are numbered by their lowest faces and are
// the components under all cuts, borders part two pieces and slits none, each piece can lie flat.
Divided divide(const TriangleMesh& mesh, int count, const Edges& given = Edges(0, 2)) {
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<char> cut = mark_cuts(topology, given);
  Divided out{divide_surface(mesh, topology, cut, count), {}, 0, {}};
  const SurfaceDivision& d = out.division;
  const std::vector<char> border = mark_cuts(topology, d.borders),
                          slit = mark_cuts(topology, d.slits);
  std::vector<char> all = cut;
  int next = 0;
  for (int piece : d.piece) {
    EXPECT_LE(piece, next);
    next = std::max(next, piece + 1);
  }
  for (std::size_t e = 0; e < all.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    EXPECT_LE(border[e] + slit[e] + cut[e], 1);
    all[e] = cut[e] || border[e] || slit[e];
    if (edge.boundary()) continue;
    const bool apart = d.piece[edge.face[0]] != d.piece[edge.face[1]];
    EXPECT_EQ(apart, border[e] || (cut[e] && apart));
    if (border[e]) out.border += (mesh.V.row(edge.v[1]) - mesh.V.row(edge.v[0])).norm();
  }
  EXPECT_EQ(pieces_of_faces(topology, all), d.piece);  // slits part nothing
  out.pieces = cut_into_pieces(mesh, topology, all);
  for (const MeshPiece& piece : out.pieces) {
    out.area.push_back(surface_area(piece.mesh));
    EXPECT_TRUE(conformal_map(piece.mesh).allFinite());
  }
  return out;
}

int loops_of(const MeshPiece& piece) {
  return static_cast<int>(boundary_loops(build_topology(piece.mesh.F)).size());
}

double largest_share(const std::vector<double>& area) {
  double sum = 0;
  for (double one : area) sum += one;
  return *std::max_element(area.begin(), area.end()) / sum * static_cast<double>(area.size());
}

TEST(DivideSurface, HalvesASphereAlongAShortLoop) {
  const Divided two = divide(test::sphere(10, 40), 2);
  ASSERT_EQ(two.pieces.size(), 2u);
  EXPECT_EQ(two.division.slits.rows(), 0);
  EXPECT_LT(largest_share(two.area), 1.05);
  EXPECT_LT(two.border, 1.2 * 2 * M_PI * 40);
  for (const MeshPiece& piece : two.pieces) EXPECT_EQ(loops_of(piece), 1);
}

TEST(DivideSurface, PiecesHaveAboutTheSameAreaAndNoTeeth) {
  const TriangleMesh sphere = test::sphere(12, 40);
  const MeshTopology topology = build_topology(sphere.F);
  for (int count : {3, 4, 5, 6, 8, 12}) {
    const Divided made = divide(sphere, count);
    EXPECT_EQ(static_cast<int>(made.pieces.size()), count);
    EXPECT_LT(largest_share(made.area), 1.25) << count;
    const std::vector<char> border = mark_cuts(topology, made.division.borders);
    for (int f = 0; f < sphere.F.rows(); ++f) {  // no face hangs on one side between two others
      for (int t = 0; t < 3; ++t) {
        const int g = topology.neighbour(f, t), h = topology.neighbour(f, next3(t));
        const int own = made.division.piece[f], beside = made.division.piece[g];
        EXPECT_FALSE(beside != own && beside == made.division.piece[h]) << "face " << f;
      }
    }
  }
}

TEST(DivideSurface, ATorusIsOpenedWhateverTheNumber) {
  for (int count : {1, 2, 3, 4, 6, 9}) {
    const Divided made = divide(test::torus(40, 16), count);
    EXPECT_EQ(static_cast<int>(made.pieces.size()), count);
    for (const MeshPiece& piece : made.pieces) {
      const MeshTopology own = build_topology(piece.mesh.F);
      EXPECT_EQ(handle_count(own, loops_of(piece)), 0);
      if (count > 1) {
        EXPECT_EQ(loops_of(piece), 1) << count;
      }
    }
    EXPECT_EQ(made.division.slits.rows() > 0, count < 6) << count;
  }
}

TEST(DivideSurface, HolesOfTheSurfaceStay) {
  const Divided made = divide(test::tube(24, 20, 20, 80), 2);
  ASSERT_EQ(made.pieces.size(), 2u);
  EXPECT_EQ(made.division.slits.rows(), 0);  // each half has one rim and one border
  for (const MeshPiece& piece : made.pieces) EXPECT_EQ(loops_of(piece), 2);
}

TEST(DivideSurface, WhatThereIsAlreadyCounts) {
  TriangleMesh both = test::sphere(6, 20);
  const Eigen::Index vertices = both.V.rows(), faces = both.F.rows();
  both.V.conservativeResize(2 * vertices, 3);
  both.F.conservativeResize(2 * faces, 3);
  both.V.bottomRows(vertices) = both.V.topRows(vertices).rowwise() + Eigen::RowVector3d(100, 0, 0);
  both.F.bottomRows(faces) = both.F.topRows(faces).array() + static_cast<int>(vertices);
  const Divided two = divide(both, 2);
  EXPECT_EQ(two.division.borders.rows(), 0);
  EXPECT_GT(two.division.slits.rows(), 0);  // both are closed
  const Divided four = divide(both, 4);
  EXPECT_EQ(four.pieces.size(), 4u);
  EXPECT_LT(largest_share(four.area), 1.1);  // two each

  const TriangleMesh sphere = test::sphere(8, 30);
  const Divided first = divide(sphere, 3);
  Edges given(first.division.borders.rows() + first.division.slits.rows(), 2);
  given << first.division.borders, first.division.slits;
  const Divided again = divide(sphere, 3, given);
  EXPECT_EQ(again.division.borders.rows() + again.division.slits.rows(), 0);
  EXPECT_EQ(again.division.piece, first.division.piece);
}

TEST(DivideSurface, IsTheSameEveryTime) {
  const TriangleMesh mesh = test::torus(40, 16);
  const Divided a = divide(mesh, 5), b = divide(mesh, 5);
  EXPECT_EQ(a.division.piece, b.division.piece);
  EXPECT_EQ(a.division.borders, b.division.borders);
  EXPECT_EQ(a.division.slits, b.division.slits);
}

TEST(DivideSurface, RefusesWhatCantBe) {
  const TriangleMesh patch = test::flat_patch();
  const MeshTopology topology = build_topology(patch.F);
  EXPECT_THROW(divide_surface(patch, topology, {}, 0), InvalidInput);
  const int most = static_cast<int>(patch.F.rows()) / least_faces_of_piece;
  EXPECT_THROW(divide_surface(patch, topology, {}, most + 1), InvalidInput);
  EXPECT_THROW(divide_surface(patch, topology, {}, std::numeric_limits<int>::max()), InvalidInput);
  EXPECT_NO_THROW(divide_surface(patch, topology, {}, most));
}

}  // namespace
}  // namespace curveups
