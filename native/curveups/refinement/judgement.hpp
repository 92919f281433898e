// SPDX-License-Identifier: LGPL-2.1-or-later
// Evaluates how well a design holds together, as one comparable value.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "curveups/physics/contact_forces.hpp"
#include "curveups/physics/touch_points.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {

// A repair lifts weak points to `force_goal` times f_min (what the mesh error may take is to
// spare). Points below `active_force` times f_min are rows of its steps: they must not fall below
// f_min.
inline constexpr double force_goal = 1.5, active_force = 2.0;
// The goal of the largest floors of the unilateral problem, each of which is one number.
inline constexpr double floor_goal = 1.2;

// By Touching; NaN where it was not computed.
using Floors = std::array<double, 2>;
inline constexpr Floors no_floors = {std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::quiet_NaN()};

struct Judgement {
  Eigen::VectorXd normal;  // per contact point, N
  double mean = 0;         // of contacts' points
  double f_min = 0;        // f_min_ratio of it
  int weak = 0;            // points below f_min
  double least = 0;        // in units of f_min
  double missing = 0;  // sum of what points and the floor lack of their goals, in units of f_min
  Floors floor = no_floors;  // largest floors in units of f_min
  double depth = 0;          // to which a membrane cuts into a body, mm, where it was looked at
  double overload = 0;       // sum of what pins carry beyond their glue's limit, over that limit

  // As verification judges (verdict.hpp), what was not looked at left out.
  bool valid() const { return forces_do() && is_clear(-depth); }
  bool forces_do() const {
    return weak == 0 && !is_short_of(Touching::at_corners) && !is_short_of(Touching::at_tips);
  }
  bool is_short_of(Touching where) const {
    const double largest = floor[static_cast<int>(where)];
    return !std::isnan(largest) && !floor_is_reached(largest, 1, mean / f_min);
  }
  // NaN where none was computed.
  double least_floor() const { return std::fmin(floor[0], floor[1]); }
  bool better_than(const Judgement& other) const {
    if (valid() != other.valid()) return valid();
    if (valid() && overload != other.overload) return overload < other.overload;
    if (weak != other.weak) return weak < other.weak;
    return missing + depth < other.missing + other.depth;
  }
};

// floors: N. Throws InfeasibleDesign where membranes don't press the tiles together.
Judgement judge(const Eigen::VectorXd& normal, const Floors& floors, double f_min_ratio);

}  // namespace curveups
