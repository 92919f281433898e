// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/refinement/clearance_program.hpp"
#include "curveups/refinement/target_smoothing.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges none(0, 2);

// A roof whose ridge runs along edges: too sharp a fold for some thickness.
TriangleMesh roof(double slope) {
  return test::lifted_patch(8, 7, [=](double, double y) { return -slope * std::abs(y); });
}

// Rows against central differences in a random direction of all vertices.
void expect_derivatives(const TriangleMesh& mesh, const Parameters& parameters, bool shaped,
                        bool membranes = false) {
  const ClearanceProgram program(mesh, none, parameters, membranes);
  const DesignGeometry here = program.geometry(mesh);
  ASSERT_EQ(here.shaped, shaped);
  PinSides asked;
  for (const SmallPin& pin : program.lacking(here)) asked.insert({pin.tile, pin.side});
  if (membranes) {
    ASSERT_GT(asked.size(), here.pin_bounds.small.size());
  }
  ASSERT_FALSE(asked.empty());
  std::vector<int> vertices(mesh.V.rows());
  for (int v = 0; v < mesh.V.rows(); ++v) vertices[v] = v;
  const auto rows = program.rows(here, asked, asked, vertices);
  ASSERT_GT(rows.size(), 4u);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Points3 direction = Points3::NullaryExpr(mesh.V.rows(), 3, [&] { return unit(random); });
  const double h = 1e-5;
  std::vector<std::vector<ClearanceProgram::Row>> there;
  for (double side : {1.0, -1.0}) {
    TriangleMesh moved = mesh;
    moved.V += side * h * direction;
    there.push_back(program.rows(program.geometry(moved), asked, asked, vertices));
    ASSERT_EQ(there.back().size(), rows.size());
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    double expected = 0, size = 0;
    for (const auto& [v, derivative] : rows[r].by_vertex) {
      expected += derivative.dot(direction.row(v).transpose());
      size += derivative.norm();
    }
    const double found = (there[0][r].value - there[1][r].value) / (2 * h);
    EXPECT_NEAR(found, expected, 1e-5 * (1 + size)) << "row " << r;
  }
}

TEST(ClearanceProgram, RowsAreDerivatives) {
  Parameters parameters;
  // Off symmetry, where the closed forms have kinks.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-0.4, 0.4);
  TriangleMesh mesh = roof(0.6);
  mesh.V += Points3::NullaryExpr(mesh.V.rows(), 3, [&] { return unit(random); });
  parameters.A_pin_min = 6;
  expect_derivatives(mesh, parameters, true);
  TriangleMesh sharp = roof(1.0);  // membranes over the ridge, too
  sharp.V += Points3::NullaryExpr(mesh.V.rows(), 3, [&] { return unit(random); });
  parameters.A_pin_min = 2;
  expect_derivatives(sharp, parameters, true, true);
  parameters.A_pin_min = 6;
  parameters.H_body = 14;  // back faces vanish
  expect_derivatives(mesh, parameters, false);
}

void expect_possible(const TriangleMesh& mesh, const Parameters& parameters) {
  const DesignGeometry geometry = make_geometry(mesh, none, parameters);  // throws without backs
  EXPECT_TRUE(geometry.pin_bounds.small.empty());
  EXPECT_TRUE(geometry.truncation.unresolved.empty());
}

TEST(TargetSmoothing, MakesBackFacesAndRoomWithLittleMovement) {
  // A tent inside of a plate.
  const TriangleMesh mesh = test::lifted_patch(12, 7, [](double x, double y) {
    return 10 * std::max(0.0, 1 - std::hypot(std::max(std::abs(x) - 12, 0.0), y) / 8);
  });
  Parameters parameters;
  parameters.H_body = 8;
  EXPECT_THROW(make_geometry(mesh, none, parameters), InfeasibleDesign);
  const SmoothedTarget smoothed = smooth_target(mesh, none, none, 5, parameters, {});
  EXPECT_FALSE(smoothed.fixed.empty());
  const double largest = *std::max_element(smoothed.move.begin(), smoothed.move.end());
  EXPECT_LE(largest, 5);
  EXPECT_GT(largest, 0.1);
  const MeshTopology topology = build_topology(mesh.F);
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.boundary()) continue;
    for (int v : edge.v) EXPECT_EQ(smoothed.move[v], 0) << "of the boundary";
  }
  EXPECT_LT(smoothed.remaining.size(), smoothed.fixed.size());
  EXPECT_NO_THROW(make_geometry(smoothed.mesh, none, parameters));
}

TEST(TargetSmoothing, MakesRoomUnderMembranesAndMovesTheBorderWhereNothingElseDoes) {
  const TriangleMesh mesh = roof(1.3);
  Parameters parameters;
  const SmoothedTarget smoothed = smooth_target(mesh, none, none, 3, parameters, {});
  const ClearanceProgram program(smoothed.mesh, none, parameters, true);
  const std::vector<SmallPin> lacking = program.lacking(program.geometry(smoothed.mesh));
  EXPECT_EQ(lacking.size(), smoothed.remaining.size());
  const MeshTopology topology = build_topology(mesh.F);
  double of_border = 0;
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.boundary()) continue;
    const int v = edge.v[0];
    of_border = std::max(of_border, smoothed.move[v]);
    if (std::abs(mesh.V(v, 1)) > 20) {
      EXPECT_EQ(smoothed.move[v], 0) << "far from the ridge";
    }
  }
  EXPECT_GT(of_border, 0.1);
  EXPECT_LE(of_border, 3);
}

TEST(TargetSmoothing, EndsWithTilesThatAreAllPossible) {
  // A bump inside of a plate, so that nothing is held by the boundary.
  const TriangleMesh mesh = test::lifted_patch(12, 7, [](double x, double y) {
    return 10 * std::max(0.0, 1 - std::hypot(x - 2, y - 1) / 16);
  });
  Parameters parameters;
  parameters.H_body = 4;
  const ClearanceProgram program(mesh, none, parameters);
  ASSERT_FALSE(program.geometry(mesh).pin_bounds.small.empty());
  const SmoothedTarget smoothed = smooth_target(mesh, none, none, 4, parameters, {});
  EXPECT_TRUE(smoothed.remaining.empty());
  expect_possible(smoothed.mesh, parameters);
  // Again: nothing is to be done.
  const SmoothedTarget again = smooth_target(smoothed.mesh, none, none, 4, parameters, {});
  EXPECT_EQ(again.mesh.V, smoothed.mesh.V);
  EXPECT_EQ(again.steps, 0);
  // Far away nothing moves.
  EXPECT_LT(
      std::count_if(smoothed.move.begin(), smoothed.move.end(), [](double m) { return m > 0.01; }),
      mesh.V.rows() / 2);
  // The same on any number of threads.
  const int threads = thread_count();
  set_thread_count(3);
  EXPECT_EQ(smooth_target(mesh, none, none, 4, parameters, {}).mesh.V, smoothed.mesh.V);
  set_thread_count(threads);
}

TEST(TargetSmoothing, TellsOfEachStepThoughNothingGetsRoom) {
  const TriangleMesh mesh = roof(1.1);
  Parameters parameters;
  parameters.H_body = 5;
  std::vector<double> told;
  const SmoothedTarget little =
      smooth_target(mesh, none, none, 0.05, parameters, [&](const std::string&, double share) {
        told.push_back(share);
        return true;
      });
  ASSERT_FALSE(little.remaining.empty());
  ASSERT_GT(told.size(), 4u);
  for (std::size_t k = 1; k < told.size(); ++k) EXPECT_GT(told[k], told[k - 1]);
  EXPECT_LT(told.back(), 1);
}

TEST(TargetSmoothing, StaysWithinItsBoundAndKeepsWhatIsNamed) {
  const TriangleMesh mesh = roof(1.1);
  Parameters parameters;
  parameters.H_body = 5;
  const SmoothedTarget little = smooth_target(mesh, none, none, 0.2, parameters, {});
  EXPECT_LE(*std::max_element(little.move.begin(), little.move.end()), 0.2);
  EXPECT_FALSE(little.remaining.empty());
  EXPECT_EQ(smooth_target(mesh, none, none, 0, parameters, {}).mesh.V, mesh.V);
  Edges kept(1, 2);
  const SmoothedTarget free = smooth_target(mesh, none, none, 3, parameters, {});
  const int moved =
      static_cast<int>(std::max_element(free.move.begin(), free.move.end()) - free.move.begin());
  kept << moved, moved;
  EXPECT_EQ(smooth_target(mesh, none, kept, 3, parameters, {}).move[moved], 0);
  EXPECT_THROW(smooth_target(mesh, none, none, -1, parameters, {}), InvalidInput);
  EXPECT_THROW(smooth_target(mesh, none, none, 3, parameters,
                             [](const std::string&, double) { return false; }),
               Cancelled);
  // Feasible targets stay as they are.
  const TriangleMesh dome = test::dome();
  EXPECT_EQ(smooth_target(dome, none, none, 3, Parameters(), {}).mesh.V, dome.V);
}

}  // namespace
}  // namespace curveups
