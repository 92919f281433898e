// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/face_soup.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

std::vector<std::string> kinds(const TriangleMesh& mesh, double L = 7, bool cuts = false) {
  std::vector<std::string> found;
  for (const Finding& finding : check_mesh(mesh, L, cuts)) found.push_back(finding.kind);
  return found;
}
using Kinds = std::vector<std::string>;

// The faces or vertices of a finding.
std::vector<int> rows(const Finding& finding, const std::string& of) {
  return std::get<std::vector<int>>(finding.figures.at(of));
}

TriangleMesh moebius() {
  TriangleMesh mesh = test::grid(30, 2, [](double u, double v) {
    const double a = 2 * M_PI * u, w = 20 * (v - 0.5);
    const double r = 40 + w * std::cos(a / 2);
    return Vec3(r * std::cos(a), r * std::sin(a), w * std::sin(a / 2));
  });
  for (int i = 0; i < mesh.F.size(); ++i) {
    int& v = mesh.F.data()[i];
    if (v % 31 == 30) v = (2 - v / 31) * 31;
  }
  return mesh;
}

TEST(MeshChecks, SoundSurfacesHaveNoFindings) {
  EXPECT_EQ(kinds(test::half_sphere(8, 48)), Kinds{});
  EXPECT_EQ(kinds(test::tube(20, 4, 30, 40)), Kinds{});
}

TEST(MeshChecks, ArraysThatMeanNothing) {
  EXPECT_EQ(kinds({Points3(0, 3), Triangles(0, 3)}), Kinds{"empty"});
  TriangleMesh mesh = test::flat_square(3, 50);
  mesh.F(4, 1) = 99;
  EXPECT_EQ(kinds(mesh), Kinds{"index-out-of-range"});
  EXPECT_EQ(rows(check_mesh(mesh, 7, false)[0], "faces"), std::vector<int>{4});
  mesh = test::flat_square(3, 50);
  mesh.V(5, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kinds(mesh), Kinds{"not-finite"});
  EXPECT_EQ(rows(check_mesh(mesh, 7, false)[0], "vertices"), std::vector<int>{5});
}

TEST(MeshChecks, NoManifold) {
  const TriangleMesh square = test::flat_square(3, 50);
  TriangleMesh mesh = square;
  mesh.V.row(5) = mesh.V.row(6);
  EXPECT_EQ(kinds(mesh)[0], "degenerate-faces");
  mesh = square;
  mesh.F.conservativeResize(19, 3);
  mesh.F.row(18) << mesh.F(3, 1), mesh.F(3, 2), mesh.F(3, 0);
  EXPECT_EQ(kinds(mesh)[0], "duplicate-faces");
  mesh = square;
  std::swap(mesh.F(7, 0), mesh.F(7, 1));
  EXPECT_EQ(kinds(mesh), Kinds{"inconsistent-orientation"});
  EXPECT_EQ(kinds(moebius()), Kinds{"one-sided"});

  TriangleMesh fin;  // three faces at one edge
  fin.V.resize(5, 3);
  fin.V << 0, 0, 0, 30, 0, 0, 0, 30, 0, 0, -30, 0, 0, 0, 30;
  fin.F.resize(3, 3);
  fin.F << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  EXPECT_EQ(kinds(fin), Kinds{"non-manifold-edges"});
  TriangleMesh bow;
  bow.V.resize(5, 3);
  bow.V << 0, 0, 0, 30, 0, 0, 0, 30, 0, -30, 0, 0, 0, -30, 0;
  bow.F.resize(2, 3);
  bow.F << 0, 1, 2, 0, 3, 4;
  EXPECT_EQ(kinds(bow), Kinds{"boundary-touches-itself"});
  EXPECT_EQ(rows(check_mesh(bow, 7, false)[0], "vertices"), std::vector<int>{0});
  const CleanMesh parted = clean_mesh(bow);
  EXPECT_EQ(kinds(parted.mesh), Kinds{"components"});
  EXPECT_EQ(parted.notes, std::vector<std::string>(1, "1 corners taken apart where parts touched"));
  EXPECT_EQ(clean_mesh(parted.mesh).mesh.V, parted.mesh.V);
}

TEST(MeshChecks, ClosedNeedsACut) {
  EXPECT_EQ(kinds(test::sphere(6, 40)), Kinds{"closed"});
  EXPECT_EQ(kinds(test::sphere(6, 40), 7, true), Kinds{});
}

TEST(MeshChecks, SelfIntersectionNamesTheFaces) {
  TriangleMesh cross;
  cross.V.resize(6, 3);
  cross.V << 0, 0, 0, 40, 0, 0, 0, 40, 0, 10, 10, -20, 12, 9, 30, 11, 30, 5;
  cross.F.resize(2, 3);
  cross.F << 0, 1, 2, 3, 4, 5;
  const auto findings = check_mesh(cross, 7, false);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].kind, "self-intersections");
  EXPECT_EQ(rows(findings[0], "faces"), (std::vector<int>{0, 1}));
  EXPECT_EQ(findings[1].kind, "components");
  EXPECT_FALSE(findings[1].is_error);
}

TEST(MeshChecks, CrossingsAreNotLookedForWhereThereAreKnownToBeNone) {
  const TriangleMesh plate = test::flat_square(10, 60);
  EXPECT_TRUE(check_mesh(plate, 7, false, true).empty());
  TriangleMesh thorn = plate;
  thorn.V.row(11 * 5 + 5) << 47, 31, 0.5;
  thorn.V(11 * 5 + 7, 2) = 0.3;
  ASSERT_FALSE(check_mesh(thorn, 7, false).empty());
  EXPECT_TRUE(check_mesh(thorn, 7, false, true).empty());
}

TEST(MeshChecks, WrongUnits) {
  TriangleMesh mesh = test::half_sphere(6, 0.048);  // metres
  EXPECT_EQ(kinds(mesh), Kinds{"too-small"});
  mesh.V *= 1e6;
  EXPECT_EQ(kinds(mesh), Kinds{"too-large"});
  EXPECT_TRUE(check_mesh(mesh, 7, false)[0].is_error);
  mesh = test::half_sphere(6, 48);
  mesh.V.col(0).array() += 1e7;
  ASSERT_EQ(kinds(mesh), Kinds{"huge-coordinates"});
  EXPECT_FALSE(check_mesh(mesh, 7, false)[0].is_error);
  mesh.V.col(0).array() += 1e10;
  EXPECT_TRUE(check_mesh(mesh, 7, false)[0].is_error);
}

TEST(MeshChecks, OneTileIsEnough) {
  TriangleMesh one;
  one.V.resize(3, 3);
  one.V << 0, 0, 0, 7, 0, 0, 3.5, 6, 0;
  one.F.resize(1, 3);
  one.F << 0, 1, 2;
  EXPECT_EQ(kinds(one), Kinds{});
}

TEST(CleanMesh, SoupBecomesTheMeshItWas) {
  const TriangleMesh mesh = test::half_sphere(5, 48);
  TriangleMesh soup;
  soup.V.resize(3 * mesh.F.rows(), 3);
  soup.F.resize(mesh.F.rows() + 1, 3);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) {
      soup.V.row(3 * f + t) = mesh.V.row(mesh.F(f, t)).array() + 1e-7 * (f % 3);
      soup.F(f, t) = 3 * f + (f % 7 == 3 ? 2 - t : t);  // some turned over
    }
  }
  soup.F.row(mesh.F.rows()) << 4, 3, 5;  // a double
  const CleanMesh clean = clean_mesh(soup);
  EXPECT_EQ(clean.mesh.V.rows(), mesh.V.rows());
  EXPECT_EQ(clean.mesh.F.rows(), mesh.F.rows());
  EXPECT_EQ(clean.notes.size(), 3u);
  EXPECT_EQ(kinds(clean.mesh), Kinds{});
  for (int f = 0; f < clean.mesh.F.rows(); ++f) {
    EXPECT_GT(clean.mesh.V.row(clean.mesh.F(f, 0)).dot(face_area_vector(clean.mesh, f)), 0);
  }
  EXPECT_TRUE(clean_mesh(clean.mesh).notes.empty());
}

TEST(CleanMesh, SliversGoWithoutAGap) {
  TriangleMesh mesh;  // a square whose diagonal carries a face without area
  mesh.V.resize(5, 3);
  mesh.V << 0, 0, 0, 40, 0, 0, 40, 40, 0, 0, 40, 0, 20, 20, 0;
  mesh.F.resize(4, 3);
  mesh.F << 0, 1, 2, 0, 2, 4, 0, 4, 3, 4, 2, 3;
  ASSERT_EQ(kinds(mesh)[0], "degenerate-faces");
  const CleanMesh clean = clean_mesh(mesh);
  EXPECT_EQ(kinds(clean.mesh), Kinds{});
  EXPECT_EQ(clean.mesh.F.rows(), 4);
  EXPECT_NEAR(surface_area(clean.mesh), 1600, 1e-9);
  EXPECT_EQ(boundary_loops(build_topology(clean.mesh.F)).at(0).size(), 4u);
}

// Faces without area between the points a, left... and right... of one straight edge, in any
// division: as stitching leaves them where the points of both sides differ. Returns how many.
int stitch(std::vector<std::array<int, 3>>& faces, std::vector<int> polygon, std::mt19937& random) {
  int made = 0;
  for (; polygon.size() > 2; ++made) {
    const std::size_t n = polygon.size(), i = random() % n;
    faces.push_back({polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return made;
}

// Three edges of a square stand open: each side has points of its own, and slivers lie between.
TEST(CleanMesh, StitchedSeamsCloseWhateverTheirSlivers) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    TriangleMesh mesh = test::flat_square(6, 60);
    const MeshTopology topology = build_topology(mesh.F);
    std::vector<Vec3> points;
    for (int v = 0; v < mesh.V.rows(); ++v) points.push_back(mesh.V.row(v));
    std::vector<std::array<int, 3>> faces;
    std::vector<char> used(mesh.F.rows(), 0);
    int slivers = 0, seams = 0;
    for (const MeshEdge& edge : topology.edges) {
      if (edge.boundary() || used[edge.face[0]] || used[edge.face[1]] || seams == 3) continue;
      if (random() % 8 != 0) continue;
      ++seams;
      std::vector<int> ring;  // once around the seam
      for (int f : {edge.face[0], edge.face[1]}) {
        used[f] = 1;
        int t = 0;
        while (mesh.F(f, t) == edge.v[0] || mesh.F(f, t) == edge.v[1]) ++t;
        const int apex = mesh.F(f, t), from = mesh.F(f, (t + 1) % 3), to = mesh.F(f, (t + 2) % 3);
        std::vector<double> places(random() % 12);
        for (double& place : places) place = (1 + random() % 100000) / 100002.0;
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        std::vector<int> chain{from};
        for (double place : places) {
          chain.push_back(static_cast<int>(points.size()));
          points.push_back((1 - place) * points[from] + place * points[to]);
        }
        chain.push_back(to);
        for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
          faces.push_back({apex, chain[k], chain[k + 1]});
        }
        ring.insert(ring.end(), chain.rbegin(), chain.rend() - 1);
      }
      slivers += stitch(faces, ring, random);
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
      if (!used[f]) faces.push_back({mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)});
    }
    std::shuffle(faces.begin(), faces.end(), random);
    TriangleMesh seamed{Points3(points.size(), 3), Triangles(faces.size(), 3)};
    for (std::size_t v = 0; v < points.size(); ++v) seamed.V.row(v) = points[v];
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (int t = 0; t < 3; ++t) seamed.F(f, t) = faces[f][t];
    }
    const CleanMesh clean = clean_mesh(seamed);
    ASSERT_EQ(kinds(clean.mesh), Kinds{}) << "round " << round;
    EXPECT_NEAR(surface_area(clean.mesh), 3600, 1e-8);
    EXPECT_EQ(boundary_loops(build_topology(clean.mesh.F)).at(0).size(), 24u);
    if (slivers > 0) {
      ASSERT_EQ(clean.notes.size(), 1u) << clean.notes[0];
      EXPECT_EQ(clean.notes[0], std::to_string(slivers) + " faces without area removed");
    }
  }
}

// Faces between points of one line, each edge in many of them: once more with every round.
TEST(CleanMesh, EndsOnAHeapOfSlivers) {
  std::mt19937 random(3);
  TriangleMesh heap{Points3(40, 3), Triangles(3000, 3)};
  for (int v = 0; v < 40; ++v) heap.V.row(v) << v * v, 0, 0;
  for (int i = 0; i < heap.F.size(); ++i) heap.F.data()[i] = static_cast<int>(random() % 40);
  heap.V.row(39) << 0, 50, 0;
  const TriangleMesh left = clean_mesh(heap).mesh;
  EXPECT_LT(left.F.rows(), 16 * heap.F.rows() + 64);
}

TEST(CleanMesh, RefusesWhatHasNoSizeOrNoDigitsLeft) {
  TriangleMesh mesh = test::flat_square(6, 60);
  mesh.V.rowwise() = Eigen::RowVector3d(1, 2, 3);
  EXPECT_THROW(clean_mesh(mesh), InvalidInput);
  for (double far : {1e9, 1e30, 1e160, 1e300}) {
    mesh = test::flat_square(6, 60);
    mesh.V.array() += far;
    EXPECT_THROW(clean_mesh(mesh), InvalidInput) << far;
    mesh = test::flat_square(6, 60);
    mesh.V *= far;
    EXPECT_THROW(clean_mesh(mesh), InvalidInput) << far;
  }
}

TEST(CleanMesh, KeepsTheFirstOfRepeatedFaces) {
  TriangleMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0, 0, 0, 40, 0, 0, 0, 40, 0, 40, 40, 0;
  mesh.F.resize(5, 3);
  mesh.F << 0, 1, 2, 3, 2, 1, 2, 1, 0, 1, 2, 3, 1, 2, 0;
  EXPECT_EQ(repeated_faces(mesh.F), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(clean_mesh(mesh).mesh.F, mesh.F.topRows(2));
}

TEST(CleanMesh, MillionsOfFacetsCanBeStopped) {
  const TriangleMesh mesh = test::flat_square(700, 50);
  const ProgressScope scope([](const std::string&, double) { return false; });
  EXPECT_THROW(clean_mesh(mesh), Cancelled);
  EXPECT_THROW(check_mesh(mesh, 1, false), Cancelled);
}

TEST(CleanMesh, LeavesWhatItCannotRepair) {
  TriangleMesh mesh = moebius();
  EXPECT_EQ(kinds(clean_mesh(mesh).mesh), Kinds{"one-sided"});
  mesh = test::flat_square(3, 50);
  mesh.V(5, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kinds(clean_mesh(mesh).mesh), Kinds{"not-finite"});
  EXPECT_EQ(kinds(clean_mesh({Points3(0, 3), Triangles(0, 3)}).mesh), Kinds{"empty"});
}

}  // namespace
}  // namespace curveups
