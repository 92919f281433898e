// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/actuated_design.hpp"

#include <algorithm>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Relaxed states with either membrane stronger, without friction and finite elements.
std::array<RestState, 2> relax_mismatched(const TileBodies& bodies, const SolvedDesign& solved,
                                          const TriangleMesh& target) {
  std::array<RestState, 2> out;
  parallel_for(2, [&](int s) {
    std::array<double, 2> pull = {1, 1};
    pull[s] += membrane_mismatch;
    TileWorld world = make_tile_world(bodies, solved, pull);
    out[s] = Path(bodies, world, target, 0, {}).relax(nullptr);
  });
  return out;
}

std::optional<std::array<double, 2>> spread_of(const std::vector<const RestState*>& states) {
  std::array<double, 2> out = {states[0]->scan.mean, states[0]->scan.mean};
  for (const RestState* state : states) {
    if (!state->at_rest) return std::nullopt;
    out = {std::min(out[0], state->scan.mean), std::max(out[1], state->scan.mean)};
  }
  return out;
}

}  // namespace

ActuatedDesign actuate_design(const Design& given, const PathOptions& options,
                              const Progress& progress) {
  Design design = given;
  design.parameters.gravity = "off";
  const TriangleMesh& target = design.target ? *design.target : design.mesh;
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  const SolvedDesign at_target = solve_design(bodies.geometry, design, progress);
  SolvedDesign solved = at_target;  // moves along with the tiles
  TileWorld world = make_tile_world(bodies, at_target);
  ActuatedDesign out;
  out.friction_coefficient = design.parameters.friction_coefficient;
  out.contacts = static_cast<int>(bodies.geometry.tiles.contacts.size());
  Path path(bodies, world, target, out.friction_coefficient, options);
  try {
    out.relaxed = path.relax(&solved);
    const std::array<RestState, 2> mismatched = relax_mismatched(bodies, at_target, target);
    out.released = path.release();
    out.shaken = path.shake();
    out.spread = spread_of({&*out.relaxed, &*out.shaken, &mismatched[0], &mismatched[1]});
    out.pressed = path.press();
  } catch (const Cancelled&) {
    if (!out.relaxed) throw;
    out.stopped = true;
  }
  out.frames = path.frames();
  return out;
}

}  // namespace curveups
