// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/refinement/merit_terms.hpp"
#include "support/term_checks.hpp"

namespace curveups {
namespace {

TEST(MeritTerms, MatchFiniteDifferences) {
  const int count = 7;
  const Points3 places = Points3::Random(count, 3),
                moved = places + 0.3 * Points3::Random(count, 3);
  const Eigen::VectorXd area =
      Eigen::VectorXd::Constant(count, 1.5) + Eigen::VectorXd::Random(count);
  std::vector<char> free(count, 1);
  free[3] = 0;
  test::expect_derivatives<3>(TargetDistance(places, area), moved, free, test::Curvature::exact);
  // Some below the goal, some above, none at it.
  BlockVector<1> force(count);
  force << 0.2, 1.4, -0.3, 0.9, 2.0, 1.05, 0.5;
  test::expect_derivatives<1>(MissingForce(1.1), force, free, test::Curvature::exact);
}

TEST(MeritTerms, ClosedForms) {
  Points3 place(1, 3), vertex(1, 3);
  place << 1, 2, 3;
  vertex << 1, 2, 5;
  EXPECT_DOUBLE_EQ(TargetDistance(place, Eigen::VectorXd::Constant(1, 3)).value(vertex), 12);
  BlockVector<1> force(3);
  force << 1, 0.5, -0.5;
  EXPECT_DOUBLE_EQ(MissingForce(1).value(force), 0.25 + 2.25);
}

}  // namespace
}  // namespace curveups
