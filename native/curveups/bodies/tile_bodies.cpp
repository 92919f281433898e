// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/tile_bodies.hpp"

#include "curveups/bodies/tile_print.hpp"

namespace curveups {

TileBodies make_tile_bodies(const Design& design) {
  TileBodies out;
  out.parameters = design.parameters;
  out.geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  out.poses = fit_poses(out.geometry.tiles, design.T);
  out.q = design.q;
  out.bumps = plan_bumps(out.geometry, out.poses, out.parameters);
  check_pins(out.geometry.tiles, out.bumps.body, out.q);
  return out;
}

}  // namespace curveups
