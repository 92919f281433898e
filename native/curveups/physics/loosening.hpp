// SPDX-License-Identifier: LGPL-2.1-or-later
// What becomes of a design whose glue does not bear what some pins carry: these let go of the
// membrane, all together; their neighbours then carry more, and those that can't let go as well.
// Where more than a quarter of the pins of a side let go, the piece counts as one that does not
// hold. A loose membrane spans its pin freely; it is let through the tile below.
#pragma once

#include "curveups/physics/solved_design.hpp"

namespace curveups {

struct Loosening {
  LoosePins pins;     // none where the glue bears all
  int rounds = 0;     // of pins that let go
  bool holds = true;  // pushing forces within friction reach f_min without them, as a verdict asks
  // N, of the last solution: at corners or tips, whichever is less. Without a value where a part
  // of a membrane hangs on no pin or found no equilibrium.
  std::optional<double> largest_floor;
  double f_min = 0;  // N
};

// overloaded: of `solved`, in which all pins are glued; tips: bump_tips of the design.
// Throws Cancelled.
Loosening loosen_pins(const DesignGeometry& geometry, const SolvedDesign& solved,
                      const LoosePins& overloaded, const std::vector<Points3>& tips,
                      const Progress& progress);

}  // namespace curveups
