// SPDX-License-Identifier: LGPL-2.1-or-later
// The drag of a step along a path. Bodies beside one another resist each other's motion, as glue,
// membranes and walls do, and the air resists each body a little. So what moves as one moves
// easily, and a body alone does not run away. A function of poses, least where the step begins.
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

  // lone: the drag on a body alone, over that between two.
  Drag(const std::vector<Pair>& pairs, const Poses& from, double lever, double lone);

  // How far two bodies beside one another have moved against one another, halfway between them as
  // the step begins, and turned (times the lever): the largest, mm.
  double furthest_apart(const Poses& poses) const;
  // The same for small motions from these poses.
  double furthest_apart(const Poses& poses, const Motions& motions) const;
  // weight / 2 (sum of the squares of what pairs have moved and turned against one another + lone
  // |motions_between|^2), N mm, for a weight in N / mm.
  double value(const Poses& poses, double weight) const;
  // Adds to the gradient and, where it is not null, to the second derivatives: convex ones, without
  // weight * lone, which the caller adds to the whole diagonal. Returns the value.
  double derivatives(const Poses& poses, double weight, Motions& gradient,
                     const MotionHessian* hessian) const;
  double lone() const { return lone_; }

 private:
  struct Joint {
    Pair pair;
    std::array<Vec3, 2> point;  // halfway between the bodies, as each of them sees it
    Eigen::Matrix3d turn;       // of the second body as the first one sees it
  };
  static Vec3 gap(const Joint& joint, const Poses& poses);
  double squares(const Joint& joint, const Poses& poses) const;

  std::vector<Joint> joints_;
  Poses from_;
  double lever_, lone_;
};

}  // namespace curveups
