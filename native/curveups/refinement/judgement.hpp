// SPDX-License-Identifier: LGPL-2.1-or-later
// Evaluates how well a design holds together, as one comparable value.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "curveups/physics/contact_forces.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {

// A repair lifts weak points to `force_goal` times f_min (what the mesh error may take is to
// spare). Points below `active_force` times f_min are rows of its steps: they must not fall below
// f_min.
inline constexpr double force_goal = 1.5, active_force = 2.0;
// The goal of the largest floor of the unilateral problem.
inline constexpr double floor_goal = 1.2;

// A largest floor that was not computed.
inline constexpr double no_floor = std::numeric_limits<double>::quiet_NaN();

struct Judgement {
  Eigen::VectorXd normal;  // per contact point, N
  double mean = 0;         // of contacts' points
  double f_min = 0;        // f_min_ratio of it
  int weak = 0;            // points below f_min
  double least = 0;        // in units of f_min
  double missing = 0;  // sum of what points and the floor lack of their goals, in units of f_min
  double floor = no_floor;  // largest floor in units of f_min
  double depth = 0;         // to which a membrane cuts into a body, mm, where it was looked at

  // As verification judges (verdict.hpp), what was not looked at left out.
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

}  // namespace curveups
