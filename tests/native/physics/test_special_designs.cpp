// SPDX-License-Identifier: LGPL-2.1-or-later
// Designs that are hard on the membranes: very loose, cut, with two different sheets, and the plain
// energy.
#include <gtest/gtest.h>

#include "curveups/core/errors.hpp"
#include "curveups/design/constraints.hpp"
#include "curveups/physics/verification.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using test::hexagon;
using test::spread_design;

Design dome(double spread = 1.35) {
  return spread_design(hexagon(3, test::cap_height), spread, 1.2);
}

void expect_equilibrium(const VerificationReport& r) {
  EXPECT_TRUE(r.physics.converged);
  for (int side = 0; side < 2; ++side) {
    EXPECT_LE(r.physics.coarse_iterations[side], 20);
    EXPECT_LE(r.physics.fine_iterations[side], 20);
  }
  EXPECT_LT(r.physics.force_balance, 1e-6);
  EXPECT_LT(r.physics.torque_balance, 1e-6);
  EXPECT_LT(r.contact_forces.imbalance, 1e-9);
}

TEST(SpecialDesign, TilesThreeTimesTheNeededGapApart) {
  // The least spread at which all gaps are three times d_gap_min.
  double low = 1, high = 3;
  for (int k = 0; k < 30; ++k) {
    const double spread = 0.5 * (low + high);
    const Design design = dome(spread);
    Parameters parameters = design.parameters;
    parameters.d_gap_min *= 3;
    const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, parameters);
    const bool apart =
        check_constraints(geometry, design.T, design.q, parameters).max_gap_violation_mm < 1e-6;
    (apart ? high : low) = spread;
  }
  EXPECT_GT(high, 1.1);
  EXPECT_LT(high, 2.9);
  expect_equilibrium(verify_design(dome(high), {}));
}

TEST(SpecialDesign, ACutTakesItsContactsAndMembraneAway) {
  Design design = dome();
  const VerificationReport whole = verify_design(design, {});
  // A slit along edges from the middle to the rim.
  const TileMesh tiles = make_tile_mesh(design.mesh, design.cuts, 3);
  std::vector<std::array<int, 2>> slit;
  for (const MeshEdge& edge : tiles.topology.edges) {
    const Vec3 a = design.mesh.V.row(edge.v[0]), b = design.mesh.V.row(edge.v[1]);
    if (std::abs(a.y()) < 1e-9 && std::abs(b.y()) < 1e-9 && a.x() + b.x() > 0) {
      slit.push_back({edge.v[0], edge.v[1]});
    }
  }
  ASSERT_EQ(slit.size(), 3u);
  design.cuts.resize(3, 2);
  for (int k = 0; k < 3; ++k) design.cuts.row(k) << slit[k][0], slit[k][1];
  const VerificationReport cut = verify_design(design, {});
  expect_equilibrium(cut);
  EXPECT_EQ(cut.contact_tiles.rows() + 3, whole.contact_tiles.rows());
  EXPECT_LT(cut.physics.triangles, whole.physics.triangles);
  EXPECT_EQ(cut.unilateral.status, SolveStatus::converged);
}

TEST(SpecialDesign, TwoDifferentMembranes) {
  Design design = dome();
  const VerificationReport same = verify_design(design, {});
  design.parameters.shear_modulus_back = 1.44;
  design.parameters.thickness_back = 0.3;
  const VerificationReport other = verify_design(design, {});
  expect_equilibrium(other);
  // Forces of a side are proportional to its modulus times thickness: 1.44 x 0.3 over 0.72 x 0.5.
  design.parameters.shear_modulus_front = 1.44;
  design.parameters.thickness_front = 0.3;
  const VerificationReport both = verify_design(design, {});
  const double size = same.solved->elastic.cwiseAbs().maxCoeff();
  EXPECT_LT((both.solved->elastic - 1.2 * same.solved->elastic).cwiseAbs().maxCoeff(), 1e-7 * size);
  EXPECT_GT((other.solved->elastic - same.solved->elastic).cwiseAbs().maxCoeff(), 1e-3 * size);
  EXPECT_GT((other.solved->elastic - both.solved->elastic).cwiseAbs().maxCoeff(), 1e-3 * size);
}

TEST(SpecialDesign, ThePlainEnergyGivesTheSameForcesWhereNothingWrinkles) {
  Design design = dome();
  const VerificationReport relaxed = verify_design(design, {});
  design.parameters.membrane_model = "neo-hookean";
  const VerificationReport plain = verify_design(design, {});
  EXPECT_TRUE(plain.physics.converged);
  EXPECT_LT(plain.physics.force_balance, 1e-6);
  EXPECT_LT(std::abs(plain.contact_forces.normal_mean / relaxed.contact_forces.normal_mean - 1),
            relaxed.physics.wrinkled_fraction + 2e-3);
}

}  // namespace
}  // namespace curveups
