// SPDX-License-Identifier: LGPL-2.1-or-later
// Wrenches and normal forces against the mesh size: first order, and the default's error.
#include <gtest/gtest.h>

#include "curveups/physics/verification.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using test::hexagon;
using test::spread_design;

constexpr int levels = 4;

// Wrenches on the default mesh and its uniform refinements.
std::array<Wrenches, levels> nested_wrenches(const Design& design, const DesignGeometry& geometry) {
  const Parameters& p = design.parameters;
  const FlatPoses poses = fit_poses(geometry.tiles, design.T);
  const int count = geometry.tiles.tile_count();
  const Points3 centres = tile_centres(geometry.tiles);
  std::array<Wrenches, levels> out;
  out.fill(Wrenches::Zero(count, 6));
  for (Side side : {Side::front, Side::back}) {
    const Points2 flat = flat_pin_corners(geometry.tiles, poses, design.q, side);
    const Points3 actuated = actuated_pin_corners(geometry.tiles, design.q, side, p.H_pin);
    MembraneMesh mesh =
        make_membrane_mesh(make_membrane_domain(geometry.tiles, side), flat, membrane_mesh_size(p));
    Points3 x;
    for (int level = 0; level < levels; ++level) {
      if (level > 0) mesh = refine_mesh(mesh);
      const Points3 glued = vertex_positions(mesh.weights, actuated);
      MembraneEquilibrium equilibrium(mesh, vertex_positions(mesh.weights, flat), p.tau,
                                      membrane_material(p, side));
      const MembraneState state = equilibrium.solve(level == 0 ? glued : prolong(mesh, x, glued));
      EXPECT_TRUE(state.solve.converged());
      EXPECT_LE(state.solve.iterations, 20);
      x = state.x;
      out[level] += membrane_wrenches(mesh, state, centres);
    }
  }
  return out;
}

struct Levels {
  Levels()
      : design(spread_design(hexagon(2, test::cap_height), 1.35, 1.2)),
        geometry(make_geometry(design.mesh, design.cuts, design.parameters)),
        wrenches(nested_wrenches(design, geometry)),
        reference(extrapolate(wrenches[levels - 1], wrenches[levels - 2])) {}
  Design design;
  DesignGeometry geometry;
  std::array<Wrenches, levels> wrenches;
  Wrenches reference;
};

class Convergence : public ::testing::Test {
 protected:
  static const Levels& solved() {
    static const Levels all;  // for all tests
    return all;
  }
  const Design& design_ = solved().design;
  const std::array<Wrenches, levels>& wrenches_ = solved().wrenches;
  const Wrenches& reference_ = solved().reference;
  BalanceSystem system_{interface_points(solved().geometry.tiles, solved().geometry.patches),
                        tile_centres(solved().geometry.tiles),
                        design_.parameters.L,
                        {}};

  Eigen::VectorXd normal(const Wrenches& wrenches) {
    return solve_contact_forces(system_, wrenches).force.col(0);
  }
  // Means over the points, over the mean normal force.
  double normal_error(const Wrenches& wrenches) {
    const Eigen::VectorXd exact = normal(reference_);
    return (normal(wrenches) - exact).cwiseAbs().mean() / exact.mean();
  }
  // Means over the tiles, over the mean force on one.
  double force_error(const Wrenches& wrenches) const {
    return (wrenches - reference_).leftCols<3>().rowwise().norm().mean() / mean_force();
  }
  double torque_error(const Wrenches& wrenches) const {
    return (wrenches - reference_).rightCols<3>().rowwise().norm().mean() /
           (design_.parameters.L * mean_force());
  }
  double mean_force() const { return reference_.leftCols<3>().rowwise().norm().mean(); }
};

TEST_F(Convergence, IsOfFirstOrderInForcesTorquesAndNormalForces) {
  // The last two make the reference: their ratio would be a half by construction.
  for (int level = 1; level + 1 < levels; ++level) {
    EXPECT_NEAR(normal_error(wrenches_[level]) / normal_error(wrenches_[level - 1]), 0.5, 0.1);
    EXPECT_NEAR(force_error(wrenches_[level]) / force_error(wrenches_[level - 1]), 0.5, 0.1);
    EXPECT_NEAR(torque_error(wrenches_[level]) / torque_error(wrenches_[level - 1]), 0.5, 0.1);
  }
}

TEST_F(Convergence, TheDefaultsErrorIsSmallAndStated) {
  const Wrenches extrapolated = extrapolate(wrenches_[1], wrenches_[0]);
  const double error = normal_error(extrapolated);
  EXPECT_LT(error, 0.015);
  EXPECT_LT(error, 0.5 * normal_error(wrenches_[1]));
  EXPECT_LT(force_error(extrapolated), force_error(wrenches_[1]));
  const VerificationReport report = verify_design(design_, {});
  EXPECT_LT(error, report.physics.normal_force_error);
  EXPECT_LT(report.physics.normal_force_error, 0.015);
}

// 99 % of the area is stretched less than a limit, which meshes that resolve the other hundredth
// reach.
TEST_F(Convergence, TheStretchOfAllButAHundredthConverges) {
  std::array<double, 4> of_most;
  for (int k = 0; k < 4; ++k) {
    Design finer = design_;
    finer.parameters.mesh_size = 0.65 / (1 << k);
    of_most[k] = verify_design(finer, {}).physics.stretch_99;
  }
  EXPECT_NEAR(of_most[3] / of_most[2], 1, 0.04);
  EXPECT_NEAR(of_most[0] / of_most[3], 1, 0.15);  // the default's
}

}  // namespace
}  // namespace curveups
