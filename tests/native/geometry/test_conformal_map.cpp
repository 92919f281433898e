// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

double map_area(const TriangleMesh& mesh, const Points2& map) {
  double area = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec2 a = map.row(mesh.F(f, 0)), b = map.row(mesh.F(f, 1)), c = map.row(mesh.F(f, 2));
    area += 0.5 * wedge(b - a, c - a);
  }
  return area;
}

// Largest difference, in rad, between a corner's angle on the surface and in the map.
double worst_angle(const TriangleMesh& mesh, const Points2& map) {
  double worst = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) {
      const int a = mesh.F(f, t), b = mesh.F(f, next3(t)), c = mesh.F(f, prev3(t));
      const Vec3 u = mesh.V.row(b) - mesh.V.row(a), v = mesh.V.row(c) - mesh.V.row(a);
      const Vec2 p = map.row(b) - map.row(a), q = map.row(c) - map.row(a);
      worst = std::max(worst, std::abs(std::atan2(u.cross(v).norm(), u.dot(v)) -
                                       std::atan2(wedge(p, q), p.dot(q))));
    }
  }
  return worst;
}

TEST(ConformalMap, FlatMeshMovesRigidly) {
  TriangleMesh mesh = test::flat_square(7, 30);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -0.5).normalized()).matrix();
  mesh.V = (mesh.V * turn.transpose()).rowwise() + Eigen::RowVector3d(300, -20, 7);
  const Points2 map = conformal_map(mesh);
  for (int i = 0; i < mesh.V.rows(); ++i) {
    for (int j = 0; j < i; ++j) {
      EXPECT_NEAR((map.row(i) - map.row(j)).norm(), (mesh.V.row(i) - mesh.V.row(j)).norm(), 1e-8);
    }
  }
  EXPECT_GT(conformal_scale(mesh, map).minCoeff(), 1 - 1e-9);
  EXPECT_NEAR(map.colwise().mean().norm(), 0, 1e-8);
}

TEST(ConformalMap, HalfSphereIsTheStereographicProjection) {
  const double radius = 48;
  const TriangleMesh mesh = test::half_sphere(16, radius);
  const Points2 map = conformal_map(mesh);
  EXPECT_LT(worst_angle(mesh, map), 0.06);
  EXPECT_NEAR(map_area(mesh, map), surface_area(mesh), 1e-9 * surface_area(mesh));
  // Scale c (1 + |p|^2 / c'^2): from 1/sqrt 2 at the pole to sqrt 2 at the rim by area.
  const Eigen::VectorXd scale = conformal_scale(mesh, map);
  EXPECT_NEAR(scale.minCoeff(), std::sqrt(0.5), 0.02);
  EXPECT_NEAR(scale.maxCoeff(), std::sqrt(2), 0.06);
}

TEST(ConformalMap, SmallestMeshes) {
  TriangleMesh one;
  one.V.resize(4, 3);
  one.V << 9, 9, 9, 0, 0, 5, 3, 0, 5, 0, 4, 5;  // vertex 0 is used by no face
  one.F.resize(1, 3);
  one.F << 1, 2, 3;
  Points2 map = conformal_map(one);
  EXPECT_NEAR((map.row(1) - map.row(2)).norm(), 3, 1e-9);
  EXPECT_NEAR((map.row(2) - map.row(3)).norm(), 5, 1e-9);
  EXPECT_NEAR(map_area(one, map), 6, 1e-9);
  EXPECT_EQ(map.row(0).norm(), 0);

  TriangleMesh two;
  two.V.resize(4, 3);
  two.V << 0, 0, 0, 7, 0, 0, 3, 6, 0, 4, -5, 3;
  two.F.resize(2, 3);
  two.F << 0, 1, 2, 1, 0, 3;
  map = conformal_map(two);
  EXPECT_LT(worst_angle(two, map), 1e-8);  // two triangles unfold
  EXPECT_GT(conformal_scale(two, map).minCoeff(), 0);
}

TEST(ConformalMap, LongStripsUnroll) {
  const TriangleMesh spiral = test::grid(200, 1, [](double u, double v) {
    const double angle = 3 * M_PI * u;
    return Vec3(30 * std::cos(angle), 30 * std::sin(angle), 5 * v);
  });
  const Points2 map = conformal_map(spiral);
  EXPECT_LT(worst_angle(spiral, map), 1e-6);
  EXPECT_NEAR((map.row(0) - map.row(200)).norm(), 90 * M_PI, 0.05);
}

TEST(ConformalMap, TubeBecomesARing) {
  const TriangleMesh mesh = test::tube(40, 12, 20, 40);
  const Points2 map = conformal_map(mesh);
  EXPECT_GT(conformal_scale(mesh, map).minCoeff(), 0);
  // Conformally a ring whose radii have the ratio exp(height / radius).
  const auto loops = boundary_loops(build_topology(mesh.F));
  ASSERT_EQ(loops.size(), 2u);
  std::vector<double> radius;
  for (const auto& loop : loops) {
    Vec2 centre = Vec2::Zero();
    for (int v : loop) centre += map.row(v).transpose() / loop.size();
    double mean = 0;
    for (int v : loop) mean += (map.row(v).transpose() - centre).norm() / loop.size();
    radius.push_back(mean);
  }
  const double ratio = std::max(radius[0], radius[1]) / std::min(radius[0], radius[1]);
  EXPECT_NEAR(ratio, std::exp(2.0), 0.15);
}

TEST(ConformalMap, HornsStayUnflipped) {
  const TriangleMesh mesh = test::grid(60, 60, [](double u, double v) {
    const double x = 100 * (u - 0.5), y = 100 * (v - 0.5);
    double z = 0;
    for (double c : {-22.0, 22.0}) z += 45 * std::exp(-((x - c) * (x - c) + y * y) / 120);
    return Vec3(x, y, z);
  });
  const Points2 map = conformal_map(mesh);
  const Eigen::VectorXd scale = conformal_scale(mesh, map);
  EXPECT_GT(scale.minCoeff(), 0);
  EXPECT_LT(scale.minCoeff(), 0.3);  // the horns' tips shrink: the case is what it is meant to be
}

TEST(ConformalMap, CutSphereLiesFlat) {
  const TriangleMesh mesh = test::sphere(8, 30);
  EXPECT_THROW(conformal_map(mesh), TopologyError);
  const MeshTopology topology = build_topology(mesh.F);
  std::vector<char> cut;
  for (const MeshEdge& edge : topology.edges) {
    const Vec3 a = mesh.V.row(edge.v[0]), b = mesh.V.row(edge.v[1]);
    cut.push_back(std::abs(a.y()) < 1e-9 && std::abs(b.y()) < 1e-9 && a.x() > -1e-9 &&
                  b.x() > -1e-9);
  }
  const TriangleMesh open = cut_open(mesh, topology, cut).mesh;
  const Points2 map = conformal_map(open);
  EXPECT_GT(conformal_scale(open, map).minCoeff(), 0);
  EXPECT_NEAR(map_area(open, map), surface_area(mesh), 1e-9 * surface_area(mesh));
}

TEST(ConformalMap, DoesNotDependOnUnitsOrRepetition) {
  TriangleMesh mesh = test::half_sphere(6, 48);
  const Points2 map = conformal_map(mesh);
  EXPECT_EQ(map, conformal_map(mesh));
  mesh.V *= 1e-3;
  EXPECT_LT((conformal_map(mesh) * 1e3 - map).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ConformalMap, RefusesWhatHasNoFlatLayout) {
  TriangleMesh two = test::flat_square(1, 1);
  two.F.resize(2, 3);
  two.V.resize(6, 3);
  two.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0;
  two.F << 0, 1, 2, 3, 4, 5;
  EXPECT_THROW(conformal_map(two), TopologyError);

  TriangleMesh torus = test::torus(12, 8);
  torus.F.conservativeResize(torus.F.rows() - 1, 3);
  try {
    conformal_map(torus);
    FAIL() << "a handle was accepted";
  } catch (const TopologyError& error) {
    EXPECT_NE(std::string(error.what()).find("1 handle"), std::string::npos) << error.what();
  }

  TriangleMesh flat = test::flat_square(2, 1);
  flat.V.row(4) = flat.V.row(1);
  EXPECT_THROW(conformal_map(flat), SolverFailure);
}

}  // namespace
}  // namespace curveups
