// SPDX-License-Identifier: LGPL-2.1-or-later
// What resists motion along a path, from where a step begins: mostly that bodies beside one another
// move against one another, as glue, membranes and walls do, and a little that a body moves at all,
// as the air does. What moves as one, however far, moves easily, and a single body that runs away
// does not. A quadratic function of motions.
#pragma once

#include "curveups/contact/motion_energy.hpp"

namespace curveups {

class Drag {
 public:
  // Two bodies beside one another, and the number of their coupling in a matrix's pattern.
  struct Pair {
    std::array<int, 2> body;
    int coupling;
  };

  Drag() = default;
  // lone: the part of a body by itself, over that of a pair.
  Drag(std::vector<Pair> pairs, const Poses& from, double lever, double lone);

  // How far two bodies beside one another move against one another, halfway between them, and turn:
  // the largest, mm.
  double furthest_apart(const Motions& motions) const;
  // weight / 2 (sum |motion of a pair against one another|^2 + lone sum |motion of a body|^2), N
  // mm, for a weight in N / mm.
  double value(const Motions& motions, double weight) const;
  // Adds to the gradient and, where it is not null, to the second derivatives, those of bodies by
  // themselves excepted: weight * lone on the whole diagonal. Returns the value.
  double derivatives(const Motions& motions, double weight, Motions& gradient,
                     BlockMatrix<6>* hessian) const;
  double lone() const { return lone_; }

 private:
  using Relative = Eigen::Matrix<double, 6, 1>;
  Relative relative(int pair, const Motions& motions) const;

  std::vector<Pair> pairs_;
  std::vector<Vec3> half_;  // from the first body to halfway to the second, over the lever
  double lone_ = 1;
};

}  // namespace curveups
