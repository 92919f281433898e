// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/even_edges.hpp"
#include "curveups/geometry/line_spacing.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/remesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

std::size_t loop_count(const TriangleMesh& mesh) {
  return boundary_loops(build_topology(mesh.F)).size();
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
  EXPECT_LT(distances(result.mesh.V, ClosestPoints(target)).maxCoeff(), 0.005 * L);
  EXPECT_LT(result.chord_error, 0.08 * L);
  EXPECT_NEAR(surface_area(result.mesh), surface_area(target), 0.02 * surface_area(target));
  const MeshTopology topology = build_topology(result.mesh.F);
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
  EXPECT_LT(distances(result.mesh.V, ClosestPoints(needles)).maxCoeff(), 1e-6);
  EXPECT_EQ(loop_count(result.mesh), 1u);
}

TEST(Remesh, ClosedSurfaceStaysClosed) {
  const RemeshResult result = remesh(test::sphere(24, 25), {6});
  EXPECT_EQ(loop_count(result.mesh), 0u);
  EXPECT_NEAR(result.mean_edge, 6, 0.18);
  EXPECT_LT(result.edge_cv, 0.12);
}

// Interior edges of a mesh where faces turn by more than 20 degrees: how many, and the length of
// all.
struct Folds {
  int count = 0;
  double length = 0, sharpest = 0;
};
Folds folds_of(const TriangleMesh& mesh) {
  const MeshTopology topology = build_topology(mesh.F);
  Folds folds;
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) continue;
    const Vec3 a = face_area_vector(mesh, edge.face[0]), b = face_area_vector(mesh, edge.face[1]);
    const double dihedral = std::atan2(a.cross(b).norm(), a.dot(b));
    if (dihedral < M_PI / 9) continue;
    ++folds.count;
    folds.length += (mesh.V.row(edge.v[1]) - mesh.V.row(edge.v[0])).norm();
    folds.sharpest = std::max(folds.sharpest, dihedral);
  }
  return folds;
}

TEST(Remesh, CreasesStayEdges) {
  // A roof of 80 x 60 mm whose ridge lies on no multiple of L.
  const double slope = 0.7;
  const TriangleMesh roof = test::grid(40, 20, [&](double u, double v) {
    return Vec3(80 * u, 60 * v, -slope * std::abs(80 * u - 38));
  });
  const RemeshResult kept = remesh(roof, {7, 40 * M_PI / 180});
  const Folds folds = folds_of(kept.mesh);
  EXPECT_EQ(folds.count, kept.features.rows());
  EXPECT_NEAR(folds.length, 60, 1e-9);
  EXPECT_NEAR(folds.sharpest, 2 * std::atan(slope), 1e-9);
  EXPECT_LT(kept.chord_error, 1e-9);
  EXPECT_LT(kept.edge_cv, 0.13);
  for (int e = 0; e < kept.features.rows(); ++e) {
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(kept.mesh.V(kept.features(e, k), 0), 38, 1e-9);
  }
  const RemeshResult through = remesh(roof, {7});
  EXPECT_EQ(through.features.rows(), 0);
  EXPECT_GT(through.chord_error, 0.5);
  // A threshold that nothing reaches changes nothing.
  EXPECT_EQ(remesh(roof, {7, 80 * M_PI / 180}).mesh.V, through.mesh.V);
}

TEST(Remesh, CreasesOfABoxMeetInItsCorners) {
  const TriangleMesh box = test::grid(90, 30, [](double u, double v) {  // three walls of a box
    const double s = 90 * u;
    return s < 30   ? Vec3(0, 30 - s, 30 * v)
           : s < 60 ? Vec3(s - 30, 0, 30 * v)
                    : Vec3(30, s - 60, 30 * v);
  });
  const RemeshResult result = remesh(box, {6, 0.7});
  EXPECT_NEAR(folds_of(result.mesh).length, 60, 1e-9);
  EXPECT_LT(result.chord_error, 1e-9);
  EXPECT_TRUE(check_mesh(result.mesh, 6, false).empty());
}

TEST(Remesh, GivenFeaturesStayEdgesAndShortCreasesDoNot) {
  TriangleMesh plate = test::flat_square(30, 60);
  Edges along(30, 2);  // across the plate, at a third of it
  for (int k = 0; k < 30; ++k) along.row(k) << 31 * 10 + k, 31 * 10 + k + 1;
  const RemeshResult result = remesh(plate, {7, 4, along});
  double length = 0;
  for (int e = 0; e < result.features.rows(); ++e) {
    const Vec3 a = result.mesh.V.row(result.features(e, 0));
    const Vec3 b = result.mesh.V.row(result.features(e, 1));
    EXPECT_NEAR(a.y(), 20, 1e-9);
    length += (b - a).norm();
  }
  EXPECT_NEAR(length, 60, 1e-9);
  plate.V(31 * 15 + 15, 2) = 3;  // a thorn
  EXPECT_GT(remesh(plate, {7, 0.5}).features.rows(), 0);
  EXPECT_EQ(remesh(plate, {20, 0.5}).features.rows(), 0);  // shorter than two tiles' edges
}

TEST(Remesh, TeethOfARaggedBoundaryAreNoCorners) {
  TriangleMesh plate = test::flat_square(60, 60);
  const TriangleMesh square = plate;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-0.45, 0.45);
  const MeshTopology topology = build_topology(plate.F);
  const auto loops = boundary_loops(topology);
  for (int v : loops.front()) {
    plate.V.row(v) += Eigen::RowVector3d(unit(random), unit(random), 0);
  }
  const auto shortest = [](const TriangleMesh& mesh) {
    double out = 1e9;
    for (int f = 0; f < mesh.F.rows(); ++f) {
      for (int t = 0; t < 3; ++t) {
        out = std::min(out, (mesh.V.row(mesh.F(f, next3(t))) - mesh.V.row(mesh.F(f, t))).norm());
      }
    }
    return out;
  };
  RemeshOptions options{7};
  EXPECT_LT(shortest(remesh(plate, options).mesh), 2.0);
  options.corner_reach = 3.5;
  const TriangleMesh even = remesh(plate, options).mesh;
  EXPECT_GT(shortest(even), 4.0);
  for (double x : {0.0, 60.0}) {  // four corners among the vertices
    for (double y : {0.0, 60.0}) {
      EXPECT_LT((even.V.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(), 1.5);
    }
  }
  // Straight sides change nothing.
  EXPECT_EQ(remesh(square, options).mesh.V, remesh(square, {7}).mesh.V);
}

TEST(FeatureLines, EndWhereLinesMeetAndClose) {
  Edges edges(9, 2);  // a path 0..3 whose vertex 2 has a branch to 4; a ring 5 6 7; and an end at 9
  edges << 0, 1, 2, 1, 2, 3, 2, 4, 5, 6, 7, 6, 5, 7, 8, 9, 10, 9;
  std::vector<char> ends(11, 0);
  ends[9] = 1;
  const std::vector<FeatureLine> lines = feature_lines(edges, ends);
  std::vector<std::vector<int>> found;
  for (const FeatureLine& line : lines) found.push_back(line.vertices);
  const std::vector<std::vector<int>> expected{{0, 1, 2}, {2, 3},  {2, 4},
                                               {8, 9},    {9, 10}, {5, 6, 7}};
  EXPECT_EQ(found, expected);
  for (std::size_t k = 0; k < lines.size(); ++k) EXPECT_EQ(lines[k].closed, k == 5) << k;
}

// Share of the worst face: twice its area over the square of its longest edge, seen from above.
double worst_from_above(const TriangleMesh& mesh) {
  double worst = 1;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    worst = std::min(worst, soundness(mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)),
                                      mesh.V.row(mesh.F(f, 2)), Vec3::UnitZ()));
  }
  return worst;
}

struct WithOneThread {
  WithOneThread() { set_thread_count(1); }
  ~WithOneThread() { set_thread_count(before); }
  int before = thread_count();
};

TEST(Remesh, RandomTrianglesKeepEveryFace) {
  const WithOneThread guard;  // meshes this small gain nothing by threads
  // Boundary vertices in a row, of which collapsing makes faces without area: one in six right
  // triangles had one.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> leg(3, 84), anywhere(0, 84);
  int made = 0;
  for (int k = 0; k < 1000; ++k) {
    TriangleMesh mesh{Points3::Zero(3, 3), Triangles(1, 3)};
    mesh.F << 0, 1, 2;
    if (k % 2 == 0) {
      mesh.V(1, 0) = leg(random);
      mesh.V(2, 1) = leg(random);
    } else {
      for (int v = 0; v < 3; ++v) mesh.V.row(v) << anywhere(random), anywhere(random), 0;
      if (face_area_vector(mesh, 0).z() < 0) mesh.F << 0, 2, 1;
    }
    // Slivers stay slivers: of them nothing is asked here.
    if (worst_from_above(mesh) < 0.1) continue;
    const RemeshResult result = remesh(mesh, {7});
    EXPECT_GT(worst_from_above(result.mesh), 0.02) << "triangle " << k << "\n" << mesh.V;
    const double area = surface_area(mesh);  // corners of 140 degrees and more are no corners
    if (area > 300) {
      EXPECT_NEAR(surface_area(result.mesh), area, 0.03 * area);
    }
    ++made;
  }
  EXPECT_GT(made, 700);
}

TEST(Remesh, BodiesOfTheSizeOfATileAreRefusedOrWhole) {
  const WithOneThread guard;
  // Bipyramids: collapsing edges leaves two triangles back to back of some of them, with all
  // neighbours of a corner on a line.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-16, 16);
  int refused = 0, made = 0;
  for (int k = 0; k < 400; ++k) {
    const int sides = 3 + k % 3;
    TriangleMesh mesh{Points3(sides + 2, 3), Triangles(2 * sides, 3)};
    for (int s = 0; s < sides; ++s) {
      const double a = 2 * M_PI * s / sides;
      mesh.V.row(s) << 8 * std::cos(a), 8 * std::sin(a), k % 2 == 0 ? 39 : anywhere(random) / 4;
      mesh.F.row(2 * s) << s, (s + 1) % sides, sides;
      mesh.F.row(2 * s + 1) << (s + 1) % sides, s, sides + 1;
    }
    mesh.V.row(sides) << 0, 0, k % 2 == 0 ? 40 : 8;
    mesh.V.row(sides + 1) << anywhere(random), anywhere(random), k % 2 == 0 ? 39 : -16;
    try {
      const RemeshResult result = remesh(mesh, {8});
      EXPECT_TRUE(result.mesh.V.allFinite()) << k;
      EXPECT_GE(result.mesh.F.rows(), 4) << k;
      EXPECT_EQ(loop_count(result.mesh), 0u) << k;
      ++made;
    } catch (const TopologyError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(made, 10);
}

TEST(Remesh, PlatesOfAFewTilesEnd) {
  const WithOneThread guard;
  // A square plate with a ridge: nearly all vertices end on its straight sides.
  TriangleMesh plate{Points3(625, 3), Triangles(1152, 3)};
  for (int v = 0; v < 625; ++v) {
    const double x = 2 * (v % 25) - 24, y = 2 * (v / 25) - 24;
    const double away = std::hypot(std::max(std::abs(x) - 8, 0.0), y);
    plate.V.row(v) << x, y, 12 * std::max(0.0, 1 - away / 9);
  }
  for (int k = 0; k < 576; ++k) {
    const int a = k / 24 * 25 + k % 24;
    plate.F.row(2 * k) << a, a + 1, a + 26;
    plate.F.row(2 * k + 1) << a, a + 26, a + 25;
  }
  for (const double L : {10.0, 12.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0, 20.0}) {
    const RemeshResult result = remesh(plate, {L});
    EXPECT_EQ(loop_count(result.mesh), 1u) << L;
    EXPECT_TRUE(check_mesh(result.mesh, L, false).empty()) << L;
    double from_above = 0;  // the sides are straight: what is seen from above is the whole square
    for (int f = 0; f < result.mesh.F.rows(); ++f) {
      from_above += face_area_vector(result.mesh, f).z();
    }
    EXPECT_NEAR(from_above, 48 * 48, 1e-6) << L;
  }
}

TEST(FaceGuard, UndoesMovesAndLetsOthersMend) {
  // Four faces around a vertex of the plane square.
  TriangleMesh square{Points3(5, 3), Triangles(4, 3)};
  square.V << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 0;
  square.F << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  SurfacePoints before{square.V, Points3::Zero(5, 3)};
  before.normal.col(2).setOnes();
  SurfacePoints after = before;
  after.V.row(4) << 0.7, 0.6, 0;
  SurfacePoints moved = after;
  undo_unsound_moves(square.F, before, moved);
  EXPECT_EQ(moved.V, after.V);  // spoils nothing
  after.V.row(4) << 2, 0.5, 0;  // past an edge
  undo_unsound_moves(square.F, before, after);
  EXPECT_TRUE(unsound_faces(after, square.F).empty());
  EXPECT_EQ(after.V, before.V);
  before.V.row(4) << 1.2, 0.5, 0;  // turned over: moves back are free, on the way out none is
  EXPECT_EQ(unsound_faces(before, square.F), std::vector<int>(1, 1));
  after = before;
  after.V.row(4) << 0.8, 0.5, 0;
  undo_unsound_moves(square.F, before, after);
  EXPECT_EQ(after.V(4, 0), 0.8);
  after.V.row(4) << 1.4, 0.5, 0;
  undo_unsound_moves(square.F, before, after);
  EXPECT_LE(after.V(4, 0), 1.2);
}

TEST(Remesh, StopsAndRefuses) {
  const TriangleMesh disc = builtin_target("disc", 0.1);
  {
    const ProgressScope scope([](const std::string&, double) { return false; });
    EXPECT_THROW(remesh(disc, {}), Cancelled);
  }
  EXPECT_THROW(remesh(disc, {0}), InvalidInput);
  EXPECT_THROW(remesh(disc, {std::nan("")}), InvalidInput);
  EXPECT_THROW(remesh(disc, {0.01}), InvalidInput);
  TriangleMesh spike = disc;
  spike.V(disc.F(0, 0), 2) = 4000;
  try {
    remesh(spike, {7});
    FAIL() << "an edge of 4 m was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(std::string(error.what()).find("face 1 of the surface has an edge"), 0u);
  }
  TriangleMesh broken = disc;
  broken.V(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(remesh(broken, {7}), InvalidInput);
}

}  // namespace
}  // namespace curveups
