// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy of touching bodies: each point that is behind the other's plane pushes as a spring,
// and sticks to it by a tangential spring from where contact was made. At a given largest friction
// force c = mu N the tangential energy is
//   k |u|^2 / 2 where k |u| <= c, else c |u| - c^2 / (2 k),
// convex, with a force that never leaves the cone: the minimum under it, for a c that is mu times
// the normal force there, obeys Coulomb's law. What slips stays slipped (remember), what sticks
// has its spring to return to: no creep, and nothing holds where nothing pushes.
#pragma once

#include <cmath>

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
  // Infinite: what touches when a step begins sticks in it, however little it pushes, and the rest
  // slides. (A finite limit of almost nothing would let points stick and slip by turns.)
  double friction_coefficient = 0.5;
  bool is_bonded() const { return std::isinf(friction_coefficient); }
  // Second derivatives of points that slip as if their friction, which has no stiffness along the
  // way, were a spring through its present force: a convex bound from above, which keeps Newton's
  // steps from leaping to and fro across the kinks where slipping turns round.
  bool careful = false;
  // What is bonded pulls as it pushes: a first guess where bodies touch and nothing pushes yet.
  bool glued = false;

  // Lets these (ascending) and all that touch have their place among the pairs that are coupled.
  // Whether there are new ones.
  bool couple_pairs(const std::vector<std::array<int, 2>>& others = {});
  // The place of a pair that is coupled.
  int coupling(const std::array<int, 2>& pair) const;
  std::unique_ptr<MotionEnergy> part(const BodyPart& bodies) const override;
  // Limits of friction as a part of this energy has them.
  void take_caps(const ContactEnergy& other, const BodyPart& bodies);
  void couple(std::vector<Coupling>& couplings) const override;
  double value(const Poses& poses) const override;
  double derivatives(const Poses& poses, double lever, Motions& gradient, BlockMatrix<6>* hessian,
                     int first) const override;

  // How far friction is from Coulomb's cone, N: of each body the largest difference at a point
  // between its friction and what it would be with mu times the normal force there as its limit.
  Eigen::VectorXd cone_errors(const Poses& poses) const;
  // Limits of friction, N, point by point: those of the present step, and mu times the normal
  // forces at these poses.
  Eigen::VectorXd caps() const;
  Eigen::VectorXd caps_at(const Poses& poses) const;
  void set_caps(const Eigen::VectorXd& caps);
  // mu times the normal forces, N, after these motions from the poses, to first order.
  Eigen::VectorXd caps_after(const Poses& poses, double lever, const Motions& motions) const;
  // Adds to the gradient what it gains as the limits of what slips become these. What sticks goes
  // on to stick: the second derivatives know no better.
  void add_caps(const Poses& poses, double lever, const Eigen::VectorXd& caps,
                Motions& gradient) const;
  // Lets all points stick, however little they push: a first guess.
  void stick();
  // Lets the points stick that touch at these poses, and no others.
  void bond(const Poses& poses);
  // Corners are clipped anew in the next search, and remember what the nearest ones did.
  void forget_corners();
  // What friction takes from its springs to these poses, N mm, as remember() will see it.
  double friction_work(const Poses& poses) const;
  // Ends a step: what slipped stays slipped, what does not push forgets.
  void remember(const Poses& poses);

  std::vector<TouchForce> forces(const Poses& poses) const;
  // Mean normal force of the points that push, N; 0 where none does.
  double mean_push(const Poses& poses) const;

 private:
  int touch_count() const;
  void add_pair(const TouchingPair& pair, const Poses& poses, double lever, bool second,
                MotionDerivatives<2>& out) const;
};

}  // namespace curveups
