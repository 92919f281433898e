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

// What one body's point does to the other body.
struct TouchForce {
  std::array<int, 2> body;       // as of the pair
  Vec3 position, normal;         // world; the normal points from body[0] to body[1]
  double push = 0;               // N, along the normal on body[1]
  Vec3 friction = Vec3::Zero();  // N, on body[1]
  double gap = 0, slip = 0;      // mm; slip: all the way it has slid
};

class ContactEnergy : public MotionEnergy {
 public:
  std::vector<TouchingPair> pairs;
  std::vector<std::array<int, 2>> coupled;  // pairs of bodies that touch or did so, ascending
  double friction_coefficient = 0.5;

  // Lets these (ascending) and all that touch have their place among the pairs that are coupled.
  // Whether there are new ones.
  bool couple_pairs(const std::vector<std::array<int, 2>>& others = {});
  // The place of a pair that is coupled.
  int coupling(const std::array<int, 2>& pair) const;
  void couple(std::vector<Coupling>& couplings) const override;
  double value(const Poses& poses) const override;
  double derivatives(const Poses& poses, double lever, Motions& gradient,
                     const MotionHessian* hessian) const override;

  // Sets the caps to mu times the normal forces at these poses.
  void lag_friction(const Poses& poses);
  // Sets the caps to mu times the normal forces after small motions, to first order.
  void predict_friction(const Poses& poses, double lever, const Motions& motions);
  // Change of the gradient along small motions where points slip, as caps follow normal forces: the
  // part of the derivatives of Coulomb's law that is not symmetric.
  Motions cap_derivatives(const Poses& poses, double lever, const Motions& motions) const;
  // Lets points that touch at these poses stick however hard they are pulled, and all others slide.
  void stick(const Poses& poses);
  // Has corners clipped anew in the next search.
  void forget_corners();
  // What friction takes from its springs to these poses, N mm, as remember() will see it.
  double friction_work(const Poses& poses) const;
  // Ends a step: what slipped stays slipped, what does not push forgets.
  void remember(const Poses& poses);

  std::vector<TouchForce> forces(const Poses& poses) const;
  // Mean normal force of the points that push, N; 0 where none does.
  double mean_push(const Poses& poses) const;

 private:
  void add_pair(const TouchingPair& pair, const Poses& poses, double lever,
                const MotionHessian* hessian, MotionDerivatives<2>& out) const;
};

}  // namespace curveups
