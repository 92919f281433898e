// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/actuated_design.hpp"

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {

ActuatedDesign actuate_design(const Design& given, const PathOptions& options,
                              const Progress& progress) {
  Design design = given;
  design.parameters.gravity = "off";
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  const SolvedDesign solved = solve_design(bodies.geometry, design, progress);
  TileWorld world = make_tile_world(bodies, solved);
  // Corrections to the finite elements hold for the actuated design, not on the way there.
  for (PairLoads* corrections : world.corrections) corrections->loads.clear();
  ActuatedDesign out;
  out.friction_coefficient = design.parameters.friction_coefficient;
  out.contacts = static_cast<int>(bodies.geometry.tiles.contacts.size());
  checkpoint("actuate", 0);
  Path path(bodies, world, out.friction_coefficient, options);
  try {
    out.released = path.release();
    out.shaken = path.shake();
    out.pressed = path.press();
  } catch (const Cancelled&) {
    if (path.frames().empty()) throw;
    out.stopped = true;
  }
  out.frames = path.frames();
  out.largest_rise = path.largest_rise();
  out.found_anew = path.found_anew();
  out.deepest = path.deepest();
  return out;
}

}  // namespace curveups
