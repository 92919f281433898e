// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <random>

#include "curveups/core/errors.hpp"
#include "curveups/design/parameters.hpp"
#include "curveups/physics/density.hpp"

namespace curveups {
namespace {

// F with the given principal stretches, turned at random in both planes.
Gradient32 random_gradient(double s1, double s2, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::Matrix3d noise;
  for (int i = 0; i < 9; ++i) noise(i) = uniform(generator);
  const Eigen::Matrix3d q = Eigen::HouseholderQR<Eigen::Matrix3d>(noise).householderQ();
  const double angle = 3 * uniform(generator);
  Eigen::Matrix2d r;
  r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return q.leftCols<2>() * Eigen::Vector2d(s1, s2).asDiagonal() * r.transpose();
}

struct Stretch {
  double s1, s2;
  MembraneTension tension;
};
const Stretch stretches[] = {
    {3, 2.5, MembraneTension::taut},     {3, 3, MembraneTension::taut},
    {1.4, 0.9, MembraneTension::taut},   {1.4, 0.8, MembraneTension::wrinkled},
    {3, 0.1, MembraneTension::wrinkled}, {1.02, 0.9, MembraneTension::wrinkled},
    {0.9, 0.5, MembraneTension::slack},  {0.99, 0.98, MembraneTension::slack}};

template <class Function>
void check_derivatives(const Gradient32& F, Function density) {
  const Density at = density(F, true);
  const double step = 1e-6;
  for (int i = 0; i < 6; ++i) {
    Gradient32 plus = F, minus = F;
    plus(i) += step;
    minus(i) -= step;
    const Density a = density(plus, false), b = density(minus, false);
    EXPECT_NEAR(at.gradient(i), (a.value - b.value) / (2 * step), 2e-8 * (1 + at.gradient.norm()));
    const Vector6 column = (a.gradient - b.gradient) / (2 * step);
    EXPECT_LT((at.hessian.col(i) - column).norm(), 2e-7 * (1 + at.hessian.norm()));
  }
}

TEST(Density, EveryDerivativeMatchesFiniteDifferencesInEveryBranch) {
  for (const DensityModel& model : density_models()) {
    SCOPED_TRACE(std::string(model.name));
    std::mt19937 generator(2);
    for (const Stretch& s : stretches) {
      const Gradient32 F = random_gradient(s.s1, s.s2, generator);
      EXPECT_EQ(principal_stretches(F).tension(), s.tension);
      check_derivatives(
          F, [&](const Gradient32& G, bool second) { return model.evaluate(G, 1e-4, second); });
    }
  }
}

TEST(Density, IsWhatTheParameterOffers) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.name != "membrane_model") continue;
    ASSERT_EQ(info.choices.size(), density_models().size());
    for (std::string_view choice : info.choices) EXPECT_EQ(density_model(choice).name, choice);
  }
  EXPECT_THROW(density_model("steel"), InvalidInput);
}

TEST(Density, ValuesAreThePapers) {
  std::mt19937 generator(3);
  const Gradient32 F = random_gradient(2.0, 1.5, generator);
  EXPECT_NEAR(neo_hookean(F, 0, false).value, 4 + 2.25 + 1 / 9.0 - 3, 1e-12);
  EXPECT_NEAR(tension_field(F, 0, false).value, 4 + 2.25 + 1 / 9.0 - 3, 1e-12);
  EXPECT_NEAR(tension_field(random_gradient(2.0, 0.3, generator), 0, false).value, 4 + 1 - 3,
              1e-12);
  EXPECT_EQ(tension_field(random_gradient(0.9, 0.3, generator), 0, false).value, 0);
}

TEST(Density, IsFrameIndifferentAndIsotropic) {
  std::mt19937 generator(4);
  for (const Stretch& s : stretches) {
    const double a = tension_field(random_gradient(s.s1, s.s2, generator), 1e-4, false).value;
    const double b = tension_field(random_gradient(s.s2, s.s1, generator), 1e-4, false).value;
    EXPECT_NEAR(a, b, 1e-12 * (1 + a));
  }
}

TEST(Density, RelaxedDensityIsTheLowerOneAndSmoothAcrossBranches) {
  std::mt19937 generator(5);
  for (double s1 = 0.8; s1 < 3; s1 += 0.1) {
    for (double s2 = 0.1; s2 <= s1; s2 += 0.05) {
      const Gradient32 F = random_gradient(s1, s2, generator);
      EXPECT_LE(tension_field(F, 0, false).value, neo_hookean(F, 0, false).value + 1e-12);
    }
  }
  for (double s1 : {1.2, 2.0, 3.0}) {  // across l2 = l1^-1/2
    std::mt19937 same(6), again(6);
    const Gradient32 below = random_gradient(s1, (1 - 1e-9) / std::sqrt(s1), same),
                     above = random_gradient(s1, (1 + 1e-9) / std::sqrt(s1), again);
    EXPECT_EQ(principal_stretches(below).tension(), MembraneTension::wrinkled);
    EXPECT_EQ(principal_stretches(above).tension(), MembraneTension::taut);
    const Density a = tension_field(below, 0, false), b = tension_field(above, 0, false);
    EXPECT_NEAR(a.value, b.value, 1e-8);
    EXPECT_LT((a.gradient - b.gradient).norm(), 1e-7);
  }
}

TEST(Density, PrincipalDirectionsAreEigenvectors) {
  std::mt19937 generator(9);
  for (int k = 0; k < 100; ++k) {
    const Gradient32 F = random_gradient(2.0, k % 2 ? 1.9 : 0.1, generator);
    const Eigen::Matrix2d C = F.transpose() * F;
    const Eigen::Vector2d n = principal_direction(F);
    EXPECT_NEAR(n.norm(), 1, 1e-14);
    EXPECT_LT((C * n - principal_stretches(F).l1 * n).norm(), 1e-13);
  }
  Gradient32 F = Gradient32::Zero();
  EXPECT_EQ(principal_direction(F).norm(), 1);
  F(0, 1) = 2;  // C = diag(0, 4)
  EXPECT_NEAR(std::abs(principal_direction(F).y()), 1, 1e-15);
}

TEST(Density, RelaxedHessianIsNeverIndefinite) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0.02, 3.5);
  int indefinite_plain = 0;
  for (int k = 0; k < 3000; ++k) {
    const Gradient32 F = random_gradient(uniform(generator), uniform(generator), generator);
    const Matrix6 relaxed = tension_field(F, 0, true).hessian,
                  plain = neo_hookean(F, 0, true).hessian;
    const double least = Eigen::SelfAdjointEigenSolver<Matrix6>(relaxed).eigenvalues()(0);
    EXPECT_GT(least, -1e-10 * (1 + relaxed.norm()));
    indefinite_plain += Eigen::SelfAdjointEigenSolver<Matrix6>(plain).eigenvalues()(0) < -1e-6;
  }
  EXPECT_GT(indefinite_plain, 100);  // reason for the relaxation
}

TEST(Density, RelaxedDensityIsConvexAlongSegments) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> entry(-2, 2);
  for (int k = 0; k < 3000; ++k) {
    Gradient32 a, b;
    for (int i = 0; i < 6; ++i) {
      a(i) = entry(generator);
      b(i) = entry(generator);
    }
    const double middle = tension_field(0.5 * (a + b), 0, false).value;
    const double ends = 0.5 * (tension_field(a, 0, false).value + tension_field(b, 0, false).value);
    EXPECT_LE(middle, ends + 1e-10 * (1 + std::abs(ends)));
  }
}

}  // namespace
}  // namespace curveups
