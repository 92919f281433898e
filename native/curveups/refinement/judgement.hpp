// SPDX-License-Identifier: LGPL-2.1-or-later
// How well a design holds together, in one comparable value.
#pragma once

#include <cmath>
#include <vector>

#include "curveups/physics/contact_forces.hpp"
#include "curveups/physics/verdict.hpp"
#include "curveups/refinement/repair_options.hpp"

namespace curveups {

struct Judgement {
  Eigen::VectorXd normal;  // per contact point, N
  double mean = 0;         // of contacts' points
  double f_min = 0;        // f_min_ratio of it
  int weak = 0;            // points below f_min
  double least = 0;        // in units of f_min
  double missing = 0;  // sum of what points and the floor lack of their goals, in units of f_min
  double missing_squares = 0;  // of what points lack of the penalty's goal, in units of the mean
  double floor = 0;            // largest floor in units of f_min; NaN where it was not computed
  double depth = 0;            // to which a membrane cuts into a body, mm, where it was looked at

  // As verification judges (verdict.hpp), what was not looked at left out.
  bool valid() const {
    return weak == 0 && (std::isnan(floor) || floor_is_reached(floor, 1, mean / f_min)) &&
           is_clear(-depth);
  }
  bool better_than(const Judgement& other) const {
    if (valid() != other.valid()) return valid();
    if (weak != other.weak) return weak < other.weak;
    return missing + depth < other.missing + other.depth;
  }
};

// floor: N, or NaN. Throws InfeasibleDesign where membranes don't press the tiles together.
Judgement judge(const std::vector<ContactPoint>& points, const Eigen::VectorXd& normal,
                double floor, double f_min_ratio, const RepairOptions& options);

}  // namespace curveups
