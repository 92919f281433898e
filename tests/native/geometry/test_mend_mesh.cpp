// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/mend_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/surface_deviation.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh out{Points3(a.V.rows() + b.V.rows(), 3), Triangles(a.F.rows() + b.F.rows(), 3)};
  out.V << a.V, b.V;
  out.F << a.F, b.F.array() + static_cast<int>(a.V.rows());
  return out;
}

TriangleMesh without(const TriangleMesh& mesh, const std::vector<int>& faces) {
  TriangleMesh out = mesh;
  int row = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (std::find(faces.begin(), faces.end(), f) == faces.end()) out.F.row(row++) = mesh.F.row(f);
  }
  out.F.conservativeResize(row, 3);
  return out;
}

std::size_t loops_of(const TriangleMesh& mesh) {
  return boundary_loops(build_topology(mesh.F)).size();
}

void expect_mended(const TriangleMesh& mesh, const MendOptions& options) {
  for (const Finding& finding : check_mesh(mesh, options.L, true)) {
    EXPECT_FALSE(finding.is_error) << finding.kind;
  }
  const MendedMesh again = mend_mesh(mesh, options);
  EXPECT_TRUE(again.actions.empty()) << again.actions.front();
  EXPECT_EQ(again.mesh.V, mesh.V);
  EXPECT_EQ(again.mesh.F, mesh.F);
}

const MendOptions options{7, 28};

TEST(MendMesh, LeavesWhatIsSound) {
  const TriangleMesh dome = test::half_sphere(16, 40);
  const MendedMesh mended = mend_mesh(dome, options);
  EXPECT_TRUE(mended.actions.empty());
  EXPECT_EQ(mended.mesh.V, dome.V);
  EXPECT_EQ(mended.mesh.F, dome.F);
}

TEST(MendMesh, FillsSmallHolesAlongTheSurface) {
  const TriangleMesh dome = test::half_sphere(24, 40);
  // Around one vertex of the inside, and a single face.
  std::vector<int> gone;
  const int middle = dome.F(700, 0);
  for (int f = 0; f < dome.F.rows(); ++f) {
    if ((dome.F.row(f).array() == middle).any()) gone.push_back(f);
  }
  gone.push_back(200);
  const TriangleMesh torn = without(dome, gone);
  ASSERT_EQ(loops_of(torn), 3u);
  const MendedMesh mended = mend_mesh(torn, options);
  EXPECT_EQ(loops_of(mended.mesh), 1u);
  EXPECT_EQ(mended.actions, std::vector<std::string>(1, "2 holes filled"));
  EXPECT_LT(surface_deviation(mended.mesh, dome).hausdorff, 0.25);
  expect_mended(mended.mesh, options);
  // Holes that are meant stay, and so does the boundary itself.
  EXPECT_EQ(loops_of(mend_mesh(torn, {7, 8}).mesh), 2u);
  EXPECT_EQ(loops_of(mend_mesh(torn, {7, 1e6}).mesh), 1u);
}

TEST(MendMesh, TakesFinsAndPinchedPartsApart) {
  // A plate with a fin on one of its inner edges, and a second plate that touches it in a vertex.
  TriangleMesh plate = test::flat_square(8, 60);
  TriangleMesh other = plate;
  other.V.col(0).array() += 60;
  other.V.col(1).array() += 60;
  TriangleMesh soup = together(plate, other);
  const int top = static_cast<int>(soup.V.rows());
  soup.V.conservativeResize(top + 1, 3);
  soup.V.row(top) << 30, 30, 1;
  soup.F.conservativeResize(soup.F.rows() + 1, 3);
  soup.F.bottomRows(1) << 9 * 4 + 4, 9 * 4 + 5, top;
  const MendedMesh mended = mend_mesh(soup, options);
  expect_mended(mended.mesh, options);
  EXPECT_NEAR(surface_area(mended.mesh), 2 * 60 * 60, 0.1);
  EXPECT_EQ(loops_of(mended.mesh), 2u);
  EXPECT_LT(surface_deviation(mended.mesh, together(plate, other)).hausdorff, 0.01);
}

TEST(MendMesh, ReplacesSmallIntersectionsAndLeavesLargeOnes) {
  // A thorn that leans through a bump beside it.
  TriangleMesh plate = test::flat_square(40, 60);
  plate.V.row(41 * 20 + 20) << 34.2, 30.3, 0.5;
  plate.V(41 * 20 + 22, 2) = 0.3;
  ASSERT_FALSE(self_intersecting_faces(plate).empty());
  const MendedMesh mended = mend_mesh(plate, options);
  expect_mended(mended.mesh, options);
  EXPECT_LT(mended.mesh.V.col(2).cwiseAbs().maxCoeff(), 0.35);
  EXPECT_TRUE(mended.without_crossings && self_intersecting_faces(mended.mesh).empty());
  // Two plates that cross: there is no one answer.
  TriangleMesh upright = test::flat_square(20, 40);
  upright.V.col(2) = upright.V.col(0).array() - 20.3;
  upright.V.col(0).setConstant(30.7);  // no vertex in common
  const MendedMesh crossing = mend_mesh(together(test::flat_square(20, 60), upright), {2, 8});
  EXPECT_TRUE(crossing.actions.empty());
  EXPECT_FALSE(crossing.without_crossings);
  EXPECT_FALSE(self_intersecting_faces(crossing.mesh).empty());
}

TEST(MendMesh, RemovesCrumbs) {
  TriangleMesh crumb = test::single_triangle(3);
  crumb.V.col(2).array() += 80;
  const MendedMesh mended = mend_mesh(together(test::half_sphere(12, 40), crumb), options);
  EXPECT_EQ(loops_of(mended.mesh), 1u);
  // A surface that is small altogether is no crumb.
  EXPECT_EQ(mend_mesh(crumb, options).mesh.F.rows(), 1);
}

TEST(MendMesh, RefusesAndStops) {
  TriangleMesh mesh = test::flat_square(4, 30);
  EXPECT_THROW(mend_mesh(mesh, {0, 28}), InvalidInput);
  EXPECT_THROW(mend_mesh(mesh, {7, -1}), InvalidInput);
  mesh.V(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(mend_mesh(mesh, options));
  mesh.F(0, 0) = 1000;
  EXPECT_THROW(mend_mesh(mesh, options), InvalidInput);
}

}  // namespace
}  // namespace curveups
