// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/physics/friction_needed.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

TEST(FrictionNeeded, ForcesExistWithItAndNotWithLess) {
  SampleOptions options;
  options.kx = options.ky = 0.02;
  Parameters parameters;
  parameters.mesh_size = 2;
  const Design design = sample_design(parameters, options);
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, parameters);
  const SolvedDesign solved = solve_design(geometry, design, {});
  const FrictionNeeded needed = find_friction_needed(solved, geometry, {});
  ASSERT_TRUE(needed.coefficient);
  ASSERT_GT(*needed.coefficient, 0.01);
  EXPECT_LT(*needed.coefficient, parameters.friction_coefficient);
  EXPECT_FALSE(needed.tiles.empty());
  const double f_min = solved.f_min();
  for (double less : {0.0, 0.008}) {
    BalanceSystem system = make_balance_system(geometry, parameters);
    UnilateralOptions asked;
    asked.scale = force_scale(solved);
    asked.friction_coefficient = *needed.coefficient - less;
    const UnilateralResult result =
        solve_unilateral(system, solved.loads, solved.forces.force, asked);
    EXPECT_EQ(result.largest_floor >= (1 - 2e-3) * f_min, less == 0) << result.largest_floor;
  }
}

TEST(FrictionNeeded, IsNotKnownWithoutContacts) {
  SampleOptions options;
  options.rows = options.columns = 1;
  const Design design = sample_design({}, options);
  Design cut = design;
  const DesignGeometry whole = make_geometry(design.mesh, design.cuts, design.parameters);
  cut.cuts.resize(static_cast<Eigen::Index>(whole.tiles.contacts.size()), 2);
  for (std::size_t k = 0; k < whole.tiles.contacts.size(); ++k) {
    const Contact& contact = whole.tiles.contacts[k];
    const int tile = contact.tile[0], side = contact.side[0];
    cut.cuts.row(k) << design.mesh.F(tile, side), design.mesh.F(tile, (side + 1) % 3);
  }
  const DesignGeometry geometry = make_geometry(cut.mesh, cut.cuts, cut.parameters);
  ASSERT_TRUE(geometry.tiles.contacts.empty());
  SolvedDesign solved;
  solved.design = cut;
  solved.loads = Wrenches::Zero(geometry.tiles.tile_count(), 6);
  EXPECT_FALSE(find_friction_needed(solved, geometry, {}).coefficient);
}

}  // namespace
}  // namespace curveups::test
