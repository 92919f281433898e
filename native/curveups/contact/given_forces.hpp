// SPDX-License-Identifier: LGPL-2.1-or-later
// Given forces: with a constant direction in space, such as weights, and between two bodies.
#pragma once

#include "curveups/contact/motion_energy.hpp"

namespace curveups {

// A force of constant direction on a point of a body.
struct PointLoad {
  int body;
  Vec3 point;  // in the body's coordinates
  Vec3 force;  // N, world
};

class PointLoads : public MotionEnergy {
 public:
  explicit PointLoads(std::vector<PointLoad> list) : loads(std::move(list)) {}
  std::vector<PointLoad> loads;

  void couple(std::vector<Coupling>&) const override {}
  double value(const Poses& poses) const override;
  double derivatives(const Poses& poses, double lever, Motions& gradient,
                     const MotionHessian* hessian) const override;
};

// A force on a point of body[1], constant in coordinates of body[0], and its opposite on body[0]:
// the two and their torques sum to zero whatever the motion.
struct PairLoad {
  std::array<int, 2> body;
  Vec3 point;  // in coordinates of body[1]
  Vec3 force;  // N, on body[1], in the coordinates of body[0]
};

class PairLoads : public MotionEnergy {
 public:
  explicit PairLoads(std::vector<PairLoad> list) : loads(std::move(list)) {}
  std::vector<PairLoad> loads;  // sorted by pairs of bodies

  void couple(std::vector<Coupling>& couplings) const override;
  double value(const Poses& poses) const override;
  double derivatives(const Poses& poses, double lever, Motions& gradient,
                     const MotionHessian* hessian) const override;

 private:
  std::vector<int> pairs() const;  // first load of each, then the end
  MotionDerivatives<2> of_pair(int begin, int end, const Poses& poses, double lever,
                               bool second) const;
};

}  // namespace curveups
