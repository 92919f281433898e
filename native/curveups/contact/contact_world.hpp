// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid bodies in contact under given energies, step by step. A step minimises
//   E(x) + contacts(x; c) + drag(x; x0, w)
// by Newton's method on one sparse pattern, with friction caps c that are mu times the normal
// forces at its end, and remembers where friction stuck. It is an implicit Euler step of h = 1 / w
// under a drag of w (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, IV.7).
// Bodies at rest are in balance under E and Coulomb's law alone.
//
// Bodies let go beside their place settle, each step solved to its end; bodies far from rest follow
// a path, a few iterations a step.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "curveups/contact/contact_energy.hpp"
#include "curveups/contact/drag.hpp"

namespace curveups {

// Length of a step, and accuracy of its solution.
struct Pace {
  double step_limit = 1;    // mm, about: motion of neighbours against one another in a step
  double together = 6;      // motion of a body with its neighbours, over step_limit
  double lone_drag = 0.03;  // as Drag has it
  double first_weight = 1;  // w of the first step, over the unit of forces a step_limit
  // Newton iterations of a step; `most_iterations` where it would store more energy than before.
  int iterations = 3, most_iterations = 12;
  // Forces that end a step, over those that it began with, or in the unit of forces; within
  // `tolerance` bodies are at rest.
  double share_left = 0.1, tolerance = 1e-3;
  bool projected = true;        // second derivatives; else only where exact ones are indefinite
  bool sticks_first = false;    // in the first step, points that touch (ContactWorld::stuck_poses)
  bool keeps_contacts = false;  // of the first search
  SearchOptions search;

  static Pace settling() {
    Pace pace;
    pace.together = 2;
    pace.lone_drag = 1;
    pace.iterations = pace.most_iterations = 30;
    pace.share_left = 0.05;
    pace.tolerance = 1e-4;
    pace.projected = false;
    pace.sticks_first = true;
    return pace;
  }
  // Pace of bodies that relax without friction beside their place, from that of their settling.
  // Faces that touch there go on to touch, and their planes have no ends: the energy is smooth, and
  // Newton's method converges.
  static Pace relaxing(Pace pace) {
    pace.sticks_first = false;
    pace.keeps_contacts = true;
    return pace;
  }
};

struct WorldOptions {
  double lever = 3;  // mm: turns times this are lengths (rigid_body.hpp)
  // The unit of forces is the mean normal force, the mean given force on a body, or this where it
  // is larger, N.
  double least_unit = 0;
  Pace pace = Pace::settling();
};

struct StepReport {
  bool at_rest = false;  // in balance under Coulomb's law when the step began: nothing moved
  int iterations = 0;
  int shortened = 0;    // iterations whose step was cut, and halvings of steps
  double residual = 0;  // largest force on a body when the step began, in the unit of forces
  // Energy (N mm) of the given energies and the springs of contacts, before the step with its own
  // contact points, and after it.
  double before = 0, energy = 0;
  double weight = 0;    // w, N / mm
  double friction = 0;  // work against friction, N mm
};

class ContactWorld {
 public:
  // start: a pose per body.
  ContactWorld(std::vector<RigidBody> bodies, Poses start, const WorldOptions& options);

  // Before the first step.
  void add(std::unique_ptr<MotionEnergy> energy) { energies_.push_back(std::move(energy)); }
  void set_friction(double coefficient) { contacts_.friction_coefficient = coefficient; }
  // Begins anew with this pace, from the present poses.
  void begin_path(const Pace& pace);
  const Pace& pace() const { return options_.pace; }
  // Goes on from these poses; friction keeps its history between faces that go on to touch.
  void set_poses(const Poses& poses);

  // No body moves past another (meeting.hpp). Throws Cancelled, with the poses as they were.
  StepReport step();
  // Steps until the bodies are at rest or `done` returns true; reports the last step.
  StepReport settle(int max_steps, const std::function<bool(const StepReport&)>& done = {});

  const Poses& poses() const { return poses_; }
  // Poses before anything slips (Pace::sticks_first).
  const Poses& stuck_poses() const { return stuck_poses_; }
  double energy() const { return value(poses_); }  // N mm, as steps report it
  const std::vector<RigidBody>& bodies() const { return bodies_; }
  const ContactEnergy& contacts() const { return contacts_; }
  std::vector<TouchForce> forces() const { return contacts_.forces(poses_); }
  // Force (N) of the given energies on each body, and torque about its origin (N mm).
  Motions given_forces() const;

 private:
  void search();
  std::vector<std::array<int, 2>> joined_pairs() const;
  void make_pattern();
  Drag make_drag() const;
  double stride(const Drag& drag, const Poses& to) const;
  double stride(const Drag& drag, const Poses& from, const Motions& motions) const;
  double value(const Poses& poses) const;
  double derivatives(const Poses& poses, Motions& gradient, BlockMatrix<6>* hessian,
                     bool projected) const;
  double force_unit() const;
  void factorize(const Poses& x, const Drag& drag, bool& projected);
  Motions newton_step(const Motions& gradient) const;
  void descend(const Drag& drag, double unit, bool stuck, Poses& x, StepReport& report);

  std::vector<RigidBody> bodies_;
  Poses poses_, stuck_poses_;
  WorldOptions options_;
  std::vector<std::unique_ptr<MotionEnergy>> energies_;
  ContactEnergy contacts_;
  std::vector<int> first_;  // first coupling of each energy, then of the contacts
  std::unique_ptr<BlockMatrix<6>> hessian_;
  std::optional<std::vector<std::array<int, 2>>> joined_;  // once searched
  bool searched_ = false;
  double weight_ = -1;   // w of the next step; negative: not known yet
  double rounding_ = 0;  // N: forces that rounding of positions exerts
};

}  // namespace curveups
