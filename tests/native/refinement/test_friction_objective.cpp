// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "curveups/layout/layout.hpp"
#include "curveups/refinement/friction_objective.hpp"
#include "support/forces.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

struct Laid {
  Parameters parameters;
  Iterate place;
};

Laid laid_out() {
  Laid out;
  const TriangleMesh mesh = test::dome(6);
  out.place.shape = std::make_shared<Shape>(mesh, Edges(0, 2), out.parameters);
  const LayoutResult layout = solve_layout(out.place.geometry(), out.parameters, {});
  out.place.state = state_of(out.place.model(), layout.poses, layout.q);
  return out;
}

DesignForces forces_at(const Laid& laid) {
  return test::solve_forces(laid.place.geometry(), laid.parameters, laid.place.poses(),
                            laid.place.insets());
}

FrictionObjective objective_at(const Laid& laid, const DesignForces& forces, double unit) {
  return {laid.place.geometry(), laid.parameters, laid.place.poses(), forces.loads(), unit};
}

TEST(FrictionObjective, ItsDerivativesAreThoseOfDifferences) {
  const Laid laid = laid_out();
  const DesignForces forces = forces_at(laid);
  const double unit = forces.contact_forces().normal_mean;
  const FrictionObjective objective = objective_at(laid, forces, unit);
  const StepObjective local = objective.linearise(laid.place, forces);
  const Eigen::VectorXd gradient = local.jacobian.transpose() * local.solve(local.value);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int kind = 0; kind < 2; ++kind) {  // poses, insets
    LayoutState way = LayoutState::Zero(laid.place.state.rows(), unknowns_per_tile);
    for (int i = 0; i < way.rows(); ++i) {
      for (int u = kind == 0 ? 0 : 3; u < (kind == 0 ? 3 : 9); ++u) way(i, u) = uniform(generator);
    }
    if (kind == 0) way.col(2) /= 4;
    const double step = 1e-4;
    std::array<double, 2> value;
    for (int s = 0; s < 2; ++s) {
      Laid moved = laid;
      moved.place.state += (s == 0 ? -step : step) * way;
      DesignForces there = forces_at(laid);
      there.move(moved.place.geometry(), moved.place.poses(), moved.place.insets(), {});
      value[s] = objective_at(moved, there, unit).value();
    }
    const double expected = (value[1] - value[0]) / (2 * step);
    // Tiles farther away than those around are left out.
    EXPECT_NEAR(gradient.dot(Eigen::Map<const Eigen::VectorXd>(way.data(), way.size())), expected,
                0.03 * std::abs(expected) + 1e-3)
        << kind;
  }
}

TEST(FrictionObjective, ItsValueIsThatOfItsLinearisation) {
  const Laid laid = laid_out();
  const DesignForces forces = forces_at(laid);
  const FrictionObjective objective =
      objective_at(laid, forces, forces.contact_forces().normal_mean);
  const StepObjective local = objective.linearise(laid.place, forces);
  EXPECT_GT(objective.tangential(), 0);
  // Less what active floors are worth by themselves.
  EXPECT_GE(0.5 * local.value.dot(local.solve(local.value)), objective.value() * (1 - 1e-9));
}

TEST(FrictionObjective, TipsOfBumpsHoldLessTorqueThanCorners) {
  Laid laid = laid_out();
  const DesignForces forces = forces_at(laid);
  const double unit = forces.contact_forces().normal_mean;
  const double at_tips = objective_at(laid, forces, unit).value();
  laid.parameters.bumps = "none";
  EXPECT_GT(at_tips, objective_at(laid, forces, unit).value());
}

}  // namespace
}  // namespace curveups
