// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/layout/spring_forces.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

Eigen::VectorXd forces_of(const Design& design) {
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  return spring_forces(geometry, design.parameters, fit_poses(geometry.tiles, design.T), design.q);
}

TEST(SpringForces, AFlatStripPullsAsASheetOfItsStretchDoes) {
  Design design = test::spread_design(test::flat_patch(4, 7), 1.2, 0.7);
  Parameters& p = design.parameters;
  p.bumps = "none";
  p.shear_modulus_back = p.shear_modulus_front;
  p.thickness_back = p.thickness_front;
  const Eigen::VectorXd forces = forces_of(design);
  ASSERT_GT(forces.size(), 0);
  // Equilateral tiles of inradius r: pins are 1.4 mm apart at the end and 0.2 * 2 r + 1.4 before.
  const double r = 7 / (2 * std::sqrt(3.0)), rest = 0.4 * r + 1.4;
  const double along = p.tau * 1.4 / rest, across = p.tau;
  const double width = 7 - 2 * std::sqrt(3.0) * 0.7;
  const double pull = p.shear_modulus_front * p.thickness_front * width / p.tau *
                      (along - 1 / (std::pow(along, 3) * across * across));
  // Both sides alike: each of the four points takes a quarter of both.
  for (Eigen::Index k = 0; k < forces.size(); ++k) EXPECT_NEAR(forces[k], pull / 2, 1e-9);
  EXPECT_TRUE(weak_by_springs(forces, p.f_min_ratio).empty());
}

TEST(SpringForces, AContactWhoseTilesLieFarApartIsWeak) {
  Design design = test::spread_design(test::flat_patch(4, 7), 1.2, 0.7);
  const DesignGeometry geometry = make_geometry(design.mesh, no_cuts, design.parameters);
  // One corner tile 20 mm away from the others: it has one contact or two.
  design.T.row(0).array() -= 20;
  const Eigen::VectorXd forces = forces_of(design);
  for (int k : weak_by_springs(forces, design.parameters.f_min_ratio)) {
    const std::array<int, 2>& pair = geometry.tiles.contacts[static_cast<std::size_t>(k)].tile;
    EXPECT_TRUE(pair[0] == 0 || pair[1] == 0) << k;
  }
  EXPECT_FALSE(weak_by_springs(forces, design.parameters.f_min_ratio).empty());
  EXPECT_TRUE(weak_by_springs(Eigen::VectorXd(0), 0.1).empty());
}

}  // namespace
}  // namespace curveups
