// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "curveups/physics/sensitivities.hpp"
#include "support/forces.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

struct Sample {
  Parameters parameters;
  Edges cuts;
  DesignGeometry geometry;
  FlatPoses poses;
  Array6 q;
};

// Tiles of a nearly flat target spread apart where they stand: a sound layout without an optimiser,
// with poses and insets scattered so that no symmetry hides a term.
Sample make_sample(const Edges& cuts) {
  Sample s;
  s.cuts = cuts;
  const TriangleMesh mesh = test::lifted_patch(
      4, 7, [](double x, double y) { return 0.04 * x * x + 0.03 * y * y + 0.02 * x * y; });
  s.geometry = make_geometry(mesh, cuts, s.parameters);
  const int count = s.geometry.tiles.tile_count();
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  s.poses.resize(count, 3);
  s.q.resize(count, 6);
  FlatCorners corners(count, 6);
  for (int i = 0; i < count; ++i) {
    Vec2 middle = Vec2::Zero();
    for (int t = 0; t < 3; ++t) middle += mesh.V.row(mesh.F(i, t)).head<2>().transpose() / 3;
    for (int t = 0; t < 3; ++t) {
      const Vec2 p = mesh.V.row(mesh.F(i, t)).head<2>();
      corners.row(i).segment<2>(2 * t) = (p + 0.35 * middle).transpose();
    }
  }
  s.poses = fit_poses(s.geometry.tiles, corners);
  for (int i = 0; i < count; ++i) {
    s.poses.row(i) +=
        Vec3(0.1 * uniform(generator), 0.1 * uniform(generator), 0.02 * uniform(generator))
            .transpose();
    for (int k = 0; k < 6; ++k) s.q(i, k) = 0.9 + 0.2 * uniform(generator);
  }
  return s;
}

double weighted(const DesignForces& forces, const Eigen::VectorXd& weights) {
  return weights.dot(forces.contact_forces().force.col(0));
}

// Central differences along random directions in each kind of unknown, the mesh moving along.
void expect_gradients_match(const Edges& cuts, const std::string& model) {
  Sample s = make_sample(cuts);
  s.parameters.membrane_model = model;
  s.parameters.thickness_back = 0.4;
  DesignForces forces = test::solve_forces(s.geometry, s.parameters, s.poses, s.q);
  const int points = forces.system().point_count(), count = s.geometry.tiles.tile_count();
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd functions(points, 3);
  for (int p = 0; p < points; ++p) functions.row(p) << uniform(generator), uniform(generator), 0;
  functions(points / 2, 2) = 1;  // the force of a single point
  const TriangleMesh mesh = s.geometry.tiles.mesh;
  const VertexPatches patches(s.geometry);
  std::vector<VertexPatch> vertices;
  for (int v = 0; v < mesh.V.rows(); ++v) vertices.push_back(patches.around(v));
  const std::vector<ForceGradient> gradients = force_gradients(forces, functions, vertices);
  ASSERT_EQ(gradients.size(), 3u);
  const double step = 1e-4;
  for (int kind = 0; kind < 4; ++kind) {  // positions, angles, insets, actuated vertices
    Points3 vertex_direction = Points3::Zero(mesh.V.rows(), 3);
    for (int v = 0; v < mesh.V.rows() && kind == 3; ++v) {
      vertex_direction.row(v) << uniform(generator), uniform(generator), uniform(generator);
    }
    FlatPoses pose_direction = FlatPoses::Zero(count, 3);
    Array6 inset_direction = Array6::Zero(count, 6);
    for (int i = 0; i < count; ++i) {
      if (kind == 0) pose_direction.row(i) << uniform(generator), uniform(generator), 0;
      if (kind == 1) pose_direction(i, 2) = 0.2 * uniform(generator);
      for (int k = 0; k < 6 && kind == 2; ++k) inset_direction(i, k) = uniform(generator);
    }
    std::array<Eigen::Vector3d, 4> values;
    const std::array<double, 4> at = {-2, -1, 1, 2};
    for (int m = 0; m < 4; ++m) {
      const DesignGeometry moved =
          make_geometry({mesh.V + at[m] * step * vertex_direction, mesh.F}, s.cuts, s.parameters);
      forces.move(moved, s.poses + at[m] * step * pose_direction,
                  s.q + at[m] * step * inset_direction, {});
      for (int k = 0; k < 3; ++k) values[m](k) = weighted(forces, functions.col(k));
    }
    for (int k = 0; k < 3; ++k) {
      // Fourth order: the error of the difference stays below that of the equilibrium.
      const double difference =
          (values[0](k) - 8 * values[1](k) + 8 * values[2](k) - values[3](k)) / (12 * step);
      const double exact = gradients[k].by_pose.cwiseProduct(pose_direction).sum() +
                           gradients[k].by_inset.cwiseProduct(inset_direction).sum() +
                           gradients[k].by_vertex.cwiseProduct(vertex_direction).sum();
      EXPECT_NEAR(exact / difference, 1, 1e-6) << "kind " << kind << " function " << k;
    }
  }
}

TEST(Sensitivities, MatchFiniteDifferences) {
  expect_gradients_match(Edges(0, 2), "tension-field");
}

TEST(Sensitivities, MatchFiniteDifferencesOfThePlainDensity) {
  expect_gradients_match(Edges(0, 2), "neo-hookean");
}

TEST(Sensitivities, MatchFiniteDifferencesOnACutModel) {
  Edges cuts(2, 2);
  cuts << 10, 11, 11, 12;  // a slit from the boundary inwards
  expect_gradients_match(cuts, "tension-field");
}

UnilateralResult largest_floor(const DesignForces& forces, double friction, double scale) {
  BalanceSystem system(forces.system().points(), forces.system().centres(), forces.system().lever(),
                       {});
  UnilateralOptions options;
  options.friction_coefficient = friction;
  options.scale = scale;
  options.tolerance = 1e-8;
  const ContactForces start = solve_contact_forces(system, forces.loads());
  return solve_unilateral(system, forces.loads(), start.force, options);
}

TEST(Sensitivities, OfTheLargestFloorMatchFiniteDifferences) {
  Edges cuts(2, 2);
  cuts << 10, 11, 11, 12;
  Sample s = make_sample(cuts);
  DesignForces forces = test::solve_forces(s.geometry, s.parameters, s.poses, s.q);
  const double scale = forces.contact_forces().normal_mean;
  const TriangleMesh mesh = s.geometry.tiles.mesh;
  const VertexPatches patches(s.geometry);
  std::vector<VertexPatch> vertices;
  for (int v = 0; v < mesh.V.rows(); ++v) vertices.push_back(patches.around(v));
  for (double friction : {0.3, 1.0}) {
    const UnilateralResult here = largest_floor(forces, friction, scale);
    ASSERT_NE(here.solve.status, SolveStatus::unfinished);
    ASSERT_LT(here.largest_floor, 0.999 * scale);
    const ForceGradient gradient = floor_gradient(forces, here, vertices);
    const int count = s.geometry.tiles.tile_count();
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int kind = 0; kind < 3; ++kind) {
      FlatPoses pose = FlatPoses::Zero(count, 3);
      Array6 inset = Array6::Zero(count, 6);
      Points3 vertex = Points3::Zero(mesh.V.rows(), 3);
      for (int i = 0; i < count; ++i) {
        if (kind == 0)
          pose.row(i) << uniform(generator), uniform(generator), 0.2 * uniform(generator);
        for (int k = 0; k < 6 && kind == 1; ++k) inset(i, k) = uniform(generator);
      }
      for (int v = 0; v < mesh.V.rows() && kind == 2; ++v) {
        vertex.row(v) << uniform(generator), uniform(generator), uniform(generator);
      }
      // Wide, for the optimum is known to some 1e-8 only.
      const double step = 1e-3;
      std::array<double, 2> values;
      for (int m = 0; m < 2; ++m) {
        const double h = m == 0 ? -step : step;
        const DesignGeometry moved =
            make_geometry({mesh.V + h * vertex, mesh.F}, s.cuts, s.parameters);
        forces.move(moved, s.poses + h * pose, s.q + h * inset, {});
        values[m] = largest_floor(forces, friction, scale).largest_floor;
      }
      forces.move(s.geometry, s.poses, s.q, {});
      const double difference = (values[1] - values[0]) / (2 * step);
      const double exact = gradient.by_pose.cwiseProduct(pose).sum() +
                           gradient.by_inset.cwiseProduct(inset).sum() +
                           gradient.by_vertex.cwiseProduct(vertex).sum();
      const double size = gradient.by_pose.cwiseProduct(pose).cwiseAbs().sum() +
                          gradient.by_inset.cwiseProduct(inset).cwiseAbs().sum() +
                          gradient.by_vertex.cwiseProduct(vertex).cwiseAbs().sum();
      EXPECT_NEAR(exact, difference, 1e-3 * size) << "friction " << friction << " kind " << kind;
    }
  }
}

TEST(Sensitivities, ForcesStayWhereTheWholeLayoutMovesAndComesBack) {
  Sample s = make_sample(Edges(0, 2));
  DesignForces moved = test::solve_forces(s.geometry, s.parameters, s.poses, s.q);
  const Points3 before = moved.contact_forces().force;
  const FlatPoses start = s.poses;
  s.poses.col(0).array() += 0.5;  // the whole layout: nothing may change
  moved.move(s.geometry, s.poses, s.q, {});
  EXPECT_LT((moved.contact_forces().force - before).norm(), 1e-8 * before.norm());
  moved.move(s.geometry, start, s.q, {});
  EXPECT_LT((moved.contact_forces().force - before).norm(), 1e-8 * before.norm());
}

}  // namespace
}  // namespace curveups
