// SPDX-License-Identifier: LGPL-2.1-or-later
// Explains why contacts stay weak, and names the tiles.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/refinement/judgement.hpp"
#include "curveups/refinement/layout_step.hpp"

namespace curveups {

// A contact that stays weak, and what holds it.
struct BlockedContact {
  std::array<int, 2> tiles;
  double least_force;  // in units of f_min
  Finding reason;
  std::string obstacle;  // Obstacle::what, empty where there is none
};

// The contacts with a point below f_min, in the order of the points; where there are none and the
// largest floor is below it, those that hold that floor down (critical, pairs of tiles). Each with
// the strongest obstacle of the last step on its tiles or their neighbours.
std::vector<BlockedContact> explain_weak_contacts(const TileMesh& tiles,
                                                  const std::vector<ContactPoint>& points,
                                                  const Judgement& judgement,
                                                  const std::vector<std::array<int, 2>>& critical,
                                                  const std::vector<Obstacle>& obstacles);

}  // namespace curveups
