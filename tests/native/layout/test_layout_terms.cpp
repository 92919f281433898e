// SPDX-License-Identifier: LGPL-2.1-or-later
// Every energy and every constraint of the layout against finite differences. New ones join by
// being in make_energies or make_constraints.
#include <gtest/gtest.h>

#include <set>

#include "curveups/layout/layout_terms.hpp"
#include "support/crowded_layout.hpp"
#include "support/term_checks.hpp"

namespace curveups {
namespace {

struct Sample : test::CrowdedLayout {
  Sample() : CrowdedLayout(mesh()) { add_separation(model, {3, 1, 9, 0}); }
  static TriangleMesh mesh() {
    std::srand(2);
    TriangleMesh m = test::ripples(5);
    for (int v = 0; v < m.V.rows(); ++v) m.V.row(v) += 0.7 * Eigen::RowVector3d::Random();
    return m;
  }
};

// Row by row: constraints are not squared.
void expect_jacobians(const LayoutTerm& function, const LayoutState& state) {
  const double h = 1e-5;
  const int dimension = function.dimension();
  int nonzero = 0;
  for (int b = 0; b < function.element_count(); ++b) {
    const auto tiles = function.blocks(b);
    LayoutTerm::Value exact, plus, minus;
    auto evaluate = [&](const LayoutState& at, bool derivatives, LayoutTerm::Value& out) {
      function.at(b, at, derivatives, out);
    };
    evaluate(state, true, exact);
    if (exact.value.head(dimension).norm() == 0) continue;
    ++nonzero;
    for (int k = 0; k < (tiles[1] < 0 ? 1 : 2); ++k) {
      for (int u = 0; u < unknowns_per_tile; ++u) {
        LayoutState moved = state;
        moved(tiles[k], u) += h;
        evaluate(moved, false, plus);
        moved(tiles[k], u) -= 2 * h;
        evaluate(moved, false, minus);
        for (int r = 0; r < dimension; ++r) {
          const double difference = (plus.value(r) - minus.value(r)) / (2 * h);
          const double scale =
              std::max(1.0, exact.jacobian[k].topRows(dimension).cwiseAbs().maxCoeff());
          ASSERT_NEAR(exact.jacobian[k](r, u), difference, 1e-7 * scale)
              << function.name() << " block " << b << " tile " << k << " unknown " << u;
        }
      }
    }
  }
  EXPECT_GT(nonzero, 0) << function.name() << " is zero everywhere: nothing was tested";
}

TEST(LayoutTerms, EveryDerivativeMatchesFiniteDifferences) {
  const Sample sample;
  std::set<std::string_view> names;
  for (const auto& function : make_energies(sample.model)) {
    SCOPED_TRACE(std::string(function->name()));
    names.insert(function->name());
    expect_jacobians(*function, sample.state);
    test::expect_derivatives(*function, sample.state, std::vector<char>(sample.state.rows(), 1),
                             test::Curvature::gauss_newton);
  }
  for (const auto& function : make_constraints(sample.model)) {
    SCOPED_TRACE(std::string(function->name()));
    names.insert(function->name());
    expect_jacobians(*function, sample.state);
    test::expect_derivatives(*function, sample.state, std::vector<char>(sample.state.rows(), 1),
                             test::Curvature::gauss_newton);
  }
  EXPECT_GE(names.size(), 6u);
}

// Packing's Gauss-Newton matrix with its curvature rows is the exact Hessian in the translations.
TEST(LayoutTerms, PackingCurvatureIsExact) {
  const Sample sample;
  const auto packing = make_packing_energy(sample.model);
  const double h = 1e-4;
  const int i = packing->blocks(4)[0];
  auto half_energy = [&](const LayoutState& at) {
    LayoutTerm::Value value;
    packing->at(4, at, false, value);
    return 0.5 * value.value.head(4).squaredNorm();
  };
  LayoutTerm::Value value;
  packing->at(4, sample.state, true, value);
  const Eigen::Matrix2d matrix =
      value.jacobian[0].leftCols<2>().transpose() * value.jacobian[0].leftCols<2>();
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      double difference = 0;
      for (int s = 0; s < 4; ++s) {
        LayoutState moved = sample.state;
        moved(i, a) += s % 2 == 0 ? h : -h;
        moved(i, b) += s / 2 == 0 ? h : -h;
        difference += (s == 0 || s == 3 ? 1 : -1) * half_energy(moved);
      }
      EXPECT_NEAR(matrix(a, b), difference / (4 * h * h), 1e-5 * matrix.norm());
    }
  }
}

TEST(LayoutTerms, EnergiesAreTheFormulasOfThePaper) {
  const Sample sample;
  const TileMesh& tiles = sample.geometry.tiles;
  const FlatCorners corners = flat_corners(tiles, poses_of(sample.model, sample.state));
  const Parameters p = sample.parameters;
  auto corner = [&](int tile, int t) -> Vec2 { return corners.row(tile).segment<2>(2 * t); };
  double alignment = 0, packing = 0, spring = 0;
  for (const Contact& c : tiles.contacts) {
    const int i = c.tile[0], t = c.side[0], j = c.tile[1], u = c.side[1];
    const Vec2 v11 = corner(i, t), v12 = corner(i, next3(t)), v21 = corner(j, u),
               v22 = corner(j, next3(u));
    alignment += std::pow((v11 - v21).norm() - (v12 - v22).norm(), 2) / (p.L * p.L);
    packing +=
        (std::pow((v11 - v22).norm(), 4) + std::pow((v12 - v21).norm(), 4)) / std::pow(p.L, 4);
    for (Side side : {Side::front, Side::back}) {
      const FlatPoses poses = poses_of(sample.model, sample.state);
      const Array6 q = insets_of(sample.state);
      // Pins' tops in space for B, in the plane for the midpoints' distance.
      std::array<std::array<Vec2, 3>, 2> local = {pin_corners(tiles, i, side, q.row(i).data()),
                                                  pin_corners(tiles, j, side, q.row(j).data())};
      const auto flat_i = place(poses, i, local[0]), flat_j = place(poses, j, local[1]);
      const double z = side == Side::front ? p.H_pin : -p.H_body - p.H_pin;
      auto top = [&](int k, int tile, int n) {
        return tiles.frame[tile](Vec3(local[k][n].x(), local[k][n].y(), z));
      };
      const Vec3 p11 = top(0, i, t), p12 = top(0, i, next3(t)), p22 = top(1, j, next3(u));
      const double b = (p12 - p11).cross(p22 - p11).norm() / (p12 - p11).norm();
      const double a =
          (0.5 * (flat_i[t] + flat_i[next3(t)]) - 0.5 * (flat_j[u] + flat_j[next3(u)])).norm();
      spring += std::pow(a / (p.tau * b), 2);
    }
  }
  EXPECT_NEAR(2 * make_alignment_energy(sample.model)->value(sample.state), w_a * alignment,
              1e-4 * w_a * alignment);
  EXPECT_NEAR(2 * make_packing_energy(sample.model)->value(sample.state), w_p * packing,
              1e-9 * w_p * packing);
  EXPECT_NEAR(2 * make_spring_energy(sample.model)->value(sample.state), w_s * spring,
              1e-9 * w_s * spring);
}

}  // namespace
}  // namespace curveups
