// SPDX-License-Identifier: LGPL-2.1-or-later
// Curvature rows against second differences: with them the Gauss-Newton matrix is the exact Hessian
// where each term says so.
#include <gtest/gtest.h>

#include "curveups/layout/layout_terms.hpp"
#include "support/crowded_layout.hpp"

namespace curveups {
namespace {

using Sample = test::CrowdedLayout;

LayoutTerm::Value evaluated(const LayoutTerm& function, int block, const LayoutState& state) {
  LayoutTerm::Value out;
  function.at(block, state, true, out);
  return out;
}

// The second derivative along a direction of f(state), by differences.
template <class F>
double second_difference(const LayoutState& state, const LayoutState& direction, F f) {
  const double h = 1e-4;
  return (f(state + h * direction) - 2 * f(state) + f(state - h * direction)) / (h * h);
}

struct Curvature {
  double exact;         // derivative of half the sum of squares
  double gauss_newton;  // by first derivatives alone
  double modelled;      // with the curvature rows
};

Curvature curvature(const LayoutTerm& function, int block, const LayoutState& state,
                    const LayoutState& direction) {
  const auto [i, j] = function.blocks(block);
  const LayoutTerm::Value here = evaluated(function, block, state);
  const Eigen::VectorXd rows = here.jacobian[0] * direction.row(i).transpose() +
                               here.jacobian[1] * direction.row(j).transpose();
  const int n = function.dimension();
  const auto half_energy = [&](const LayoutState& at) {
    return 0.5 * evaluated(function, block, at).value.head(n).squaredNorm();
  };
  return {second_difference(state, direction, half_energy), rows.head(n).squaredNorm(),
          rows.head(n + function.curvature_rows()).squaredNorm()};
}

TEST(CurvatureRows, OfPackingAreExactForTranslations) {
  const Sample sample(test::ripples(5));
  const auto packing = make_packing_energy(sample.model);
  for (int block = 0; block < packing->element_count(); ++block) {
    LayoutState direction = LayoutState::Zero(sample.state.rows(), sample.state.cols());
    for (int tile : packing->blocks(block)) direction.row(tile).head<2>().setRandom();
    const Curvature c = curvature(*packing, block, sample.state, direction);
    EXPECT_NEAR(c.modelled, c.exact, 1e-4 * c.exact);
    EXPECT_LT(c.gauss_newton, c.exact);
  }
}

// On a flat target the distance of facing pins is the sum of their insets. Along a change of one of
// them that leaves the pins' midpoints where they are a^2 / (2 B^2) curves by 3 a^2 / B^4.
TEST(CurvatureRows, OfSpringsAreExactAlongTheDistanceOfFacingPins) {
  const Sample sample(test::flat_patch(5));
  const auto spring = make_spring_energy(sample.model);
  for (int block = 0; block < spring->element_count(); ++block) {
    const Contact& contact = sample.geometry.tiles.contacts[block / 2];
    const int inset = inset_unknown(block % 2 == 0 ? Side::front : Side::back, contact.side[0]);
    const int facing = inset_unknown(block % 2 == 0 ? Side::front : Side::back, contact.side[1]);
    const auto [i, j] = spring->blocks(block);
    const auto stretch = [&](double by_inset, const Vec2& by_place) -> Vec2 {  // a, scaled
      LayoutState at = sample.state;
      at(i, inset) += by_inset;
      at.row(i).head<2>() += by_place.transpose();
      return evaluated(*spring, block, at).value.head<2>() * (at(i, inset) + at(j, facing));
    };
    const double scale = (stretch(0, Vec2(1, 0)) - stretch(0, Vec2::Zero())).x();
    LayoutState direction = LayoutState::Zero(sample.state.rows(), sample.state.cols());
    direction(i, inset) = 1;
    direction.row(i).head<2>() =
        -(stretch(1, Vec2::Zero()) - stretch(0, Vec2::Zero())).transpose() / scale;
    const Curvature c = curvature(*spring, block, sample.state, direction);
    EXPECT_NEAR(c.modelled, c.exact, 1e-4 * c.exact);
    EXPECT_NEAR(c.gauss_newton, c.exact / 3, 1e-4 * c.exact);
  }
}

// A gap falls off on both sides as the edge's line turns about its tile's centre.
TEST(CurvatureRows, OfGapsAreExactForTurnsOfTheEdgesTile) {
  const Sample sample(test::ripples(5));
  const auto gaps = make_gap_constraint(sample.model);
  int curved = 0;
  for (int block = 0; block < gaps->element_count(); ++block) {
    LayoutState direction = LayoutState::Zero(sample.state.rows(), sample.state.cols());
    direction(gaps->blocks(block)[0], 2) = 1;
    const LayoutTerm::Value here = evaluated(*gaps, block, sample.state);
    const double row = here.jacobian[0](1, 2);
    const double exact = -second_difference(sample.state, direction, [&](const LayoutState& at) {
      return evaluated(*gaps, block, at).value(0);
    });
    EXPECT_NEAR(row * row, std::max(0.0, exact), 1e-5);
    EXPECT_EQ(here.jacobian[0].row(1).norm(), row);
    EXPECT_EQ(here.jacobian[1].row(1).norm(), 0);
    curved += row > 0;
  }
  EXPECT_GT(curved, gaps->element_count() / 2);
}

}  // namespace
}  // namespace curveups
