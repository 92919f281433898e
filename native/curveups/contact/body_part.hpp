// SPDX-License-Identifier: LGPL-2.1-or-later
// Some of many bodies that settle by themselves while all others stand still: places that hold a
// whole up, where contacts open and close or friction sticks and slips by turns (nonlinear
// elimination, as in physics/equilibrium.hpp).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "curveups/contact/rigid_body.hpp"

namespace curveups {

// Bodies numbered anew: the first `moving` move, the others, which elements join to these, do not.
struct BodyPart {
  std::vector<int> bodies;
  int moving = 0;
  std::vector<int> number;  // of each of all bodies: its place in `bodies`, or -1

  // Gives the bodies of an element (-1: none) their numbers in the part; false where none moves.
  template <std::size_t N>
  bool take(std::array<int, N>& element) const {
    const auto moves = [&](int body) {
      return body >= 0 && number[body] >= 0 && number[body] < moving;
    };
    if (std::none_of(element.begin(), element.end(), moves)) return false;
    for (int& body : element) body = body < 0 ? body : number[body];
    return true;
  }
};

// The few bodies with the largest forces, and those that are joined to them, where all others feel
// much smaller ones; otherwise none. joined: of each body, those that elements join to it.
BodyPart worst_part(const Eigen::VectorXd& forces, const std::vector<RigidBody>& bodies,
                    const std::vector<std::vector<int>>& joined);

}  // namespace curveups
