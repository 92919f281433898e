// SPDX-License-Identifier: LGPL-2.1-or-later
// The goals of a repair and the limits of its steps.
#pragma once

namespace curveups {

struct RepairOptions {
  double trust_radius = 0.2;  // mm that an unknown moves in a step at most, at first
  // Weak points are lifted to this times f_min (what the mesh error may take is to spare), and
  // points below `active` times f_min are rows of the step: they must not fall below f_min.
  double goal = 1.5;
  double active = 2.0;
  double penalty_goal = 1.1;  // times f_min, where tightness is a penalty
  // The same for the largest floors of the unilateral problem, each of which is one number.
  double floor_goal = 1.2;
  // Vertices stay within this times L of their places in the target, by coordinate.
  double largest_displacement = 0.1;
  int max_steps = 60;
};

}  // namespace curveups
