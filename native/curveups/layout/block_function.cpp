// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/block_function.hpp"

namespace curveups {

BlockFunctions make_energies(const LayoutModel& model, bool soft) {
  BlockFunctions functions;
  functions.push_back(make_alignment_energy(model));
  functions.push_back(make_packing_energy(model));
  functions.push_back(make_spring_energy(model));
  if (soft) {
    functions.push_back(make_collision_energy(model));
    functions.push_back(make_pin_area_energy(model));
  }
  return functions;
}

BlockFunctions make_constraints(const LayoutModel& model) {
  BlockFunctions functions;
  functions.push_back(make_gap_constraint(model));
  functions.push_back(make_pin_area_constraint(model));
  functions.push_back(make_pin_keepout_constraint(model));
  return functions;
}

double energy(const BlockFunction& function, const LayoutState& state) {
  double sum = 0;
  BlockValue block;
  for (int b = 0; b < function.block_count(); ++b) {
    const auto [i, j] = function.tiles(b);
    function.evaluate(b, state.row(i).data(), j < 0 ? nullptr : state.row(j).data(), false, block);
    sum += block.value.head(function.dimension()).squaredNorm();
  }
  return sum;
}

}  // namespace curveups
