// SPDX-License-Identifier: LGPL-2.1-or-later
// The points where tiles touch: at the corners of their interfaces, or at the tips of bumps. Bumps
// stand where they fit on an interface (bump_tips), in steps and pieces; while vertices move a
// little, tips are taken to stay at the same place of their interface: a fixed affine combination
// of its corners, and a fixed height over its plane.
#pragma once

#include <array>
#include <vector>

#include "curveups/physics/balance_system.hpp"

namespace curveups {

// Where pushing forces within friction are asked for f_min: at the interfaces' corners, and at the
// bumps' tips where tiles carry bumps. One rule for both (verdict.hpp).
enum class Touching { at_corners = 0, at_tips = 1 };
inline constexpr std::array<Touching, 2> touchings = {Touching::at_corners, Touching::at_tips};

struct TouchPoints {
  // points[p] = sum_l weight[l] corners[first + l].position + height * corners[first].normal
  struct Tie {
    int first, count;
    std::array<double, 4> weight;
    double height;  // mm
  };
  std::vector<ContactPoint> points;
  std::vector<Tie> tie;
};

// Whether bumps stand on some contact. tips: per contact.
bool any_tips(const std::vector<Points3>& tips);

// corners: contact points at the corners of interfaces, those of a contact side by side. tips: per
// contact n x 3 (world); 0 x 3: nothing stands there, and the contact touches at its corners.
TouchPoints tie_to_corners(const std::vector<ContactPoint>& corners,
                           const std::vector<Points3>& tips);

// The points where the same corners are elsewhere. False, and the points as they were, where
// corners came or went.
bool follow_corners(const std::vector<ContactPoint>& corners, TouchPoints& touch);

}  // namespace curveups
