// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curveups/refinement/clearance_program.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

// A cone on which the back sides at the tip have less room than A_pin_min asks for.
struct Ridge {
  TriangleMesh mesh =
      test::lifted_patch(6, 7, [](double x, double y) { return -0.5 * std::hypot(x - 1, y); });
  Edges cuts = Edges(0, 2);
  Parameters parameters;
  std::vector<int> vertices;

  Ridge() {
    parameters.A_pin_min = 9;
    for (int v = 0; v < mesh.V.rows(); ++v) vertices.push_back(v);
  }
};

TEST(ClearanceProgram, NothingLacksOnAPlane) {
  const TriangleMesh mesh = test::flat_patch();
  const Edges cuts(0, 2);
  const Parameters parameters;
  const ClearanceProgram program(mesh, cuts, parameters, true);
  const DesignGeometry here = program.geometry(mesh);
  EXPECT_TRUE(here.shaped);
  EXPECT_EQ(program.missing(here), 0);
  EXPECT_TRUE(program.lacking(here).empty());
  TriangleMesh moved = mesh;
  const std::vector<int> vertices = {8, 9};
  EXPECT_FALSE(program.step(program.rows(here, {}, {}, vertices), vertices, {0.5, 1}, moved));
  EXPECT_LT((moved.V - mesh.V).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ClearanceProgram, NamesSidesThatLackRoomByTheirAreas) {
  const Ridge ridge;
  const ClearanceProgram program(ridge.mesh, ridge.cuts, ridge.parameters);
  const DesignGeometry here = program.geometry(ridge.mesh);
  const std::vector<SmallPin> lacking = program.lacking(here);
  ASSERT_FALSE(lacking.empty());
  EXPECT_GT(program.missing(here), 0);
  for (const SmallPin& pin : lacking) EXPECT_LT(pin.area, ridge.parameters.A_pin_min);
  EXPECT_EQ(sides_of(lacking).size(), lacking.size());
  // Tiles that are too thick have no back face at all.
  Parameters thick = ridge.parameters;
  thick.H_body = 30;
  const ClearanceProgram impossible(ridge.mesh, ridge.cuts, thick);
  EXPECT_FALSE(impossible.geometry(ridge.mesh).shaped);
}

TEST(ClearanceProgram, AStepMakesRoomWithinItsLimits) {
  const Ridge ridge;
  const ClearanceProgram program(ridge.mesh, ridge.cuts, ridge.parameters);
  const DesignGeometry here = program.geometry(ridge.mesh);
  const PinSides small = sides_of(program.lacking(here));
  const std::vector<int> vertices = vertices_around(small, ridge.mesh);
  EXPECT_LT(vertices.size(), ridge.vertices.size());
  constexpr double most = 0.1;
  TriangleMesh moved = ridge.mesh;
  ASSERT_TRUE(program.step(program.rows(here, small, small, vertices), vertices, {most, 1}, moved));
  EXPECT_LT(program.missing(program.geometry(moved)), 0.9 * program.missing(here));
  const Points3 move = moved.V - ridge.mesh.V;
  EXPECT_GT(move.cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LE(move.cwiseAbs().maxCoeff(), most + 1e-12);
  for (int v = 0; v < move.rows(); ++v) {
    if (std::find(vertices.begin(), vertices.end(), v) == vertices.end()) {
      EXPECT_EQ(move.row(v).norm(), 0);
    }
  }
}

}  // namespace
}  // namespace curveups
