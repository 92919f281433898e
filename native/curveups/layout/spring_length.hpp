// SPDX-License-Identifier: LGPL-2.1-or-later
// The actuated distance of facing pins.
#pragma once

#include <cmath>

namespace curveups {

// B of Eq. 16, mm: the distance of the facing pin edges at the pins' ends, of insets q1 and q2 and
// half the fold (negated on the back), with its derivatives by the insets.
struct SpringLength {
  double length, by_q1, by_q2;
};

inline SpringLength spring_length(double q1, double q2, double half_dihedral, double H_pin) {
  const double c = std::cos(half_dihedral), s = std::sin(half_dihedral);
  const double wide = (q1 + q2) * c + 2 * H_pin * s, high = (q1 - q2) * s;
  const double length = std::sqrt(wide * wide + high * high);
  return {length, (wide * c + high * s) / length, (wide * c - high * s) / length};
}

}  // namespace curveups
