// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/moved_pins.hpp"

namespace curveups {

bool move_pins(MembraneSolution& solution, const Points3& corners, const Parameters& parameters) {
  const int tiles = solution.domain.tile_count;
  EquilibriumOptions options;
  options.few_factorizations = true;
  if (!move_pins(solution.coarse, corners, options)) return false;
  solution.coarse_forces = pin_corner_forces(solution.coarse.mesh, solution.coarse.state, tiles);
  SolvedMembrane fine;
  fine.mesh = std::move(solution.mesh);
  fine.actuated_corners = std::move(solution.pin_corners);
  fine.state = std::move(solution.state);
  fine.equilibrium =
      std::make_unique<MembraneEquilibrium>(fine.mesh, solution.flat, parameters.tau,
                                            membrane_material(parameters, solution.domain.side));
  const bool found = move_pins(fine, corners, options);
  solution.forces = pin_corner_forces(fine.mesh, fine.state, tiles);
  solution.stretch = fine.equilibrium->energy().stretches(fine.state.x);
  solution.mesh = std::move(fine.mesh);
  solution.pin_corners = std::move(fine.actuated_corners);
  solution.state = std::move(fine.state);
  return found;
}

}  // namespace curveups
