// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "curveups/core/errors.hpp"
#include "curveups/physics/equilibrium.hpp"
#include "support/sheet.hpp"
#include "support/term_checks.hpp"

namespace curveups {
namespace {

using test::make_sheet;
using test::Sheet;

constexpr double a = 10, b = 6, tau = 1;

// Stretches the outline by sx, sy, starts the inside from somewhere else, and returns the pulls of
// the right (along x) and the upper edge (along y).
struct Pull {
  double right = 0, upper = 0;
  MembraneState state;
  std::vector<TriangleStretch> stretch;
};

Pull pull(double sx, double sy, const MembraneMaterial& material, double noise = 0.3) {
  const Sheet sheet = make_sheet(a, b, 1.0);
  MembraneEquilibrium equilibrium(sheet.mesh, sheet.flat, tau, material);
  Points3 start(sheet.flat.rows(), 3);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  for (int v = 0; v < start.rows(); ++v) {
    start.row(v) << sx * sheet.flat(v, 0), sy * sheet.flat(v, 1), 0;
    if (sheet.mesh.pin[v] < 0)
      start.row(v) += Vec3(uniform(generator), uniform(generator), uniform(generator)).transpose();
  }
  Pull out;
  out.state = equilibrium.solve(start);
  out.stretch = equilibrium.energy().stretches(out.state.x);
  // Half of the force on a corner belongs to each edge's line: sum over the whole line instead.
  for (int v = 0; v < start.rows(); ++v) {
    if (sheet.flat(v, 0) == a) out.right += out.state.gradient(v, 0);
    if (sheet.flat(v, 1) == b) out.upper += out.state.gradient(v, 1);
  }
  return out;
}

MembraneMaterial exact(const DensityModel& model) { return {0.72, 0.5, &model, 1e-12}; }

TEST(Equilibrium, EquibiaxialSheetHasTheClosedFormsForces) {
  constexpr double s = 2.5;
  for (const DensityModel& model : density_models()) {
    const MembraneMaterial m = exact(model);
    const double modulus = m.shear_modulus * m.thickness;
    const double force = modulus * (s - std::pow(s, -5));
    const double energy = 0.5 * modulus * a * b * (2 * s * s + std::pow(s, -4) - 3);
    const Pull p = pull(s, s, m);
    EXPECT_TRUE(p.state.solve.converged());
    EXPECT_NEAR(p.right / (b * force), 1, 1e-9);
    EXPECT_NEAR(p.upper / (a * force), 1, 1e-9);
    EXPECT_NEAR(p.state.energy / energy, 1, 1e-9);
    for (const TriangleStretch& t : p.stretch) {
      EXPECT_NEAR(t.larger, s, 1e-6);
      EXPECT_NEAR(t.smaller, s, 1e-6);
      EXPECT_EQ(t.tension, MembraneTension::taut);
    }
  }
}

TEST(Equilibrium, UniaxialSheetPullsInOneDirectionOnly) {
  const MembraneMaterial m = exact(density_model("tension-field"));
  const double s = 2, natural = 1 / std::sqrt(s);
  const Pull p = pull(s, natural * (1 + 1e-12), m, 0.05);
  EXPECT_TRUE(p.state.solve.converged());
  EXPECT_NEAR(p.right / (b * m.shear_modulus * m.thickness * (s - 1 / (s * s))), 1, 1e-8);
  EXPECT_NEAR(p.upper / p.right, 0, 1e-8);
}

TEST(Equilibrium, SqueezedSheetWrinklesInsteadOfPushing) {
  const MembraneMaterial m = exact(density_model("tension-field"));
  const double s = 2, expected = b * m.shear_modulus * m.thickness * (s - 1 / (s * s));
  for (double squeeze : {0.6, 0.4, 0.1}) {
    const Pull p = pull(s, squeeze, m, 0.02);
    EXPECT_TRUE(p.state.solve.converged());
    EXPECT_NEAR(p.right / expected, 1, 1e-6);
    EXPECT_NEAR(p.upper / expected, 0, 1e-6);
    for (const TriangleStretch& t : p.stretch) EXPECT_EQ(t.tension, MembraneTension::wrinkled);
  }
  // The plain density pushes back.
  EXPECT_LT(pull(s, 0.6, exact(density_model("neo-hookean")), 0).upper, -0.1 * expected);
}

TEST(Equilibrium, SlackSheetDoesNotPull) {
  const MembraneMaterial m = exact(density_model("tension-field"));
  const Pull p = pull(0.8, 0.7, m, 0.0);
  EXPECT_NEAR(p.right / (a * m.shear_modulus * m.thickness), 0, 1e-6);
  for (const TriangleStretch& t : p.stretch) EXPECT_EQ(t.tension, MembraneTension::slack);
}

TEST(Equilibrium, DerivativesMatchFiniteDifferences) {
  const Sheet sheet = make_sheet(5, 4, 1.0);
  for (const DensityModel& model : density_models()) {
    const MembraneEnergy energy(sheet.mesh, sheet.flat, 3, {0.72, 0.5, &model, 1e-4});
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> uniform(-0.4, 0.4);
    Points3 x(sheet.flat.rows(), 3);
    std::vector<char> free;
    for (int v = 0; v < x.rows(); ++v) {
      x.row(v) << sheet.flat(v, 0) + uniform(generator),
          0.4 * sheet.flat(v, 1) + uniform(generator), uniform(generator);
      free.push_back(sheet.mesh.pin[v] < 0);
    }
    test::expect_derivatives(energy, x, free, test::Curvature::exact);
  }
}

}  // namespace
}  // namespace curveups
