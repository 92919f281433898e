// SPDX-License-Identifier: LGPL-2.1-or-later
// Drag of a step along a path, a function of poses that is least where the step begins. Neighbours
// resist each other's motion, as glue, membranes and walls do, and the air resists each body a
// little: bodies move easily as one, and a body alone does not run away.
#pragma once

#include "curveups/contact/motion_energy.hpp"

namespace curveups {

class Drag {
 public:
  // Neighbours, and the number of their coupling in a matrix's pattern.
  struct Pair {
    std::array<int, 2> body;
    int coupling;
  };

  // lone: drag on a body alone, over that between two.
  Drag(const std::vector<Pair>& pairs, const Poses& from, double lever, double lone);

  // Largest motion of neighbours against one another since the step began, at the point halfway
  // between them, and turn (times the lever), mm.
  double furthest_apart(const Poses& poses) const;
  // The same for small motions from these poses.
  double furthest_apart(const Poses& poses, const Motions& motions) const;
  // weight / 2 (sum of squares of these motions and turns of all pairs + lone |motions_between|^2),
  // N mm, for a weight in N / mm.
  double value(const Poses& poses, double weight) const;
  // Adds to the gradient and, where it is not null, to the second derivatives: convex ones, without
  // weight * lone, which the caller adds to the whole diagonal. Returns the value.
  double derivatives(const Poses& poses, double weight, Motions& gradient,
                     const MotionHessian* hessian) const;
  double lone() const { return lone_; }

 private:
  struct Joint {
    Pair pair;
    std::array<Vec3, 2> point;  // halfway between the bodies, in coordinates of each
    Eigen::Matrix3d turn;       // second body in coordinates of the first
  };
  static Vec3 gap(const Joint& joint, const Poses& poses);
  double squares(const Joint& joint, const Poses& poses) const;

  std::vector<Joint> joints_;
  Poses from_;
  double lever_, lone_;
};

}  // namespace curveups
