// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy of touching bodies: each point that is behind the other's plane pushes as a spring,
// and sticks to it by a tangential spring from where contact was made. At a given cap c on its
// friction force the tangential energy is Huber's,
//   k |u|^2 / 2 where k |u| <= c, else c |u| - c^2 / (2 k),
// convex, with a force that never leaves the cone: the minimum under it, for a c that is mu times
// the normal force there, obeys Coulomb's law. Caps lag behind the normal forces, as in IPC (M. Li
// et al., Incremental Potential Contact, 2020), whose smoothed friction is replaced by the spring:
// what sticks returns, what slips stays slipped (remember), so that nothing creeps.
#pragma once

#include "curveups/contact/contact_search.hpp"
#include "curveups/contact/motion_energy.hpp"

namespace curveups {

// Contact point's force along its normal on the other body of its pair.
struct TouchForce {
  std::array<int, 2> body;  // the pair
  double push = 0;          // N
  double slip = 0;          // mm, total
};

class ContactEnergy : public MotionEnergy {
 public:
  std::vector<TouchingPair> pairs;
  std::vector<std::array<int, 2>> coupled;  // pairs of bodies with a coupling, ascending
  double friction_coefficient = 0.5;

  // Adds the pairs that touch, and others (ascending), to the coupled ones; true where one is new.
  bool couple_pairs(const std::vector<std::array<int, 2>>& others = {});
  // Number of a coupled pair.
  int coupling(const std::array<int, 2>& pair) const;
  void couple(std::vector<Coupling>& couplings) const override;
  double value(const Poses& poses) const override;
  double derivatives(const Poses& poses, double lever, Motions& gradient,
                     const MotionHessian* hessian) const override;

  // Sets the caps to mu times the normal forces at these poses.
  void lag_friction(const Poses& poses);
  // Sets the caps to infinity for points that touch at these poses, and to zero for all others.
  void stick(const Poses& poses);
  // Makes the next search clip all corners anew.
  void forget_corners();
  // Work against friction up to these poses, N mm, since remember().
  double friction_work(const Poses& poses) const;
  // Ends a step: springs keep the stretch that their caps allow.
  void remember(const Poses& poses);

  std::vector<TouchForce> forces(const Poses& poses) const;
  // Mean normal force of the points that push, N; 0 where none does.
  double mean_push(const Poses& poses) const;

 private:
  void add_pair(const TouchingPair& pair, const Poses& poses, double lever,
                const MotionHessian* hessian, MotionDerivatives<2>& out) const;
};

}  // namespace curveups
