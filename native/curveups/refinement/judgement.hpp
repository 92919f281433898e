// SPDX-License-Identifier: LGPL-2.1-or-later
// Comparable judgement of how well a design holds together.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/physics/contact_forces.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {

// A repair lifts weak points to `force_goal` times f_min, which leaves room for the mesh error.
// Points below `active_force` times f_min are rows of its steps: they must not fall below f_min.
inline constexpr double force_goal = 1.5, active_force = 2.0;
// Goal of the largest floor of the unilateral problem.
inline constexpr double floor_goal = 1.2;

// Largest floor that was not computed.
inline constexpr double no_floor = std::numeric_limits<double>::quiet_NaN();

struct Judgement {
  Eigen::VectorXd normal;  // per contact point, N
  double mean = 0;         // normal force, N
  double f_min = 0;        // f_min_ratio times the mean
  int weak = 0;            // points below f_min
  double least = 0;        // force in units of f_min
  double missing =
      0;  // sum of the differences of points and floor to their goals, in units of f_min
  double floor = no_floor;  // largest floor in units of f_min
  double depth = 0;         // mm, of a membrane's deepest cut into a body; on fresh meshes alone

  // Judges as verification does (verdict.hpp), without the figures that were not computed.
  bool valid() const { return forces_do() && is_clear(-depth); }
  bool forces_do() const { return weak == 0 && !is_short_of_floor(); }
  bool is_short_of_floor() const {
    return !std::isnan(floor) && !floor_is_reached(floor, 1, mean / f_min);
  }
  bool better_than(const Judgement& other) const {
    if (valid() != other.valid()) return valid();
    if (weak != other.weak) return weak < other.weak;
    return missing + depth < other.missing + other.depth;
  }
};

// normal, floor: N. Throws InfeasibleDesign where membranes don't press the tiles together.
Judgement judge(const Eigen::VectorXd& normal, double floor, double f_min_ratio);

// Contact that stays weak.
struct BlockedContact {
  std::array<int, 2> tiles;
  Finding reason;
};

// Contacts with a point below f_min, in the order of the points; where there are none and the
// largest floor is below it, those that bound the floor (critical, pairs of tiles).
std::vector<BlockedContact> weak_contacts(const std::vector<ContactPoint>& points,
                                          const Judgement& judgement,
                                          const std::vector<std::array<int, 2>>& critical);

}  // namespace curveups
