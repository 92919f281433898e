// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid bodies in contact under given energies, step by step. A step minimises
//   E(x) + contacts(x; c) + drag(x; x0, w)
// by Newton's method on one sparse pattern, with friction caps c that are mu times the normal
// forces at its end, and remembers where friction stuck. It is an implicit Euler step of h = 1 / w
// under a drag of w (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, IV.7).
// Bodies that come to rest are at rest under E and Coulomb's law alone.
//
// Two load cases of the one integrator: bodies that are let go beside their place settle, each step
// solved to the end; bodies far from rest follow a path, a few iterations a step, as the way
// matters and not only its end.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "curveups/contact/contact_energy.hpp"
#include "curveups/contact/drag.hpp"

namespace curveups {

// How far bodies go in a step, and how exactly it is solved.
struct Pace {
  // mm: about how far bodies beside one another may move against one another in a step.
  double step_limit = 1;
  // How many times as far a body may move with those beside it.
  double together = 6;
  double largest_turn = 0.5;  // of a body in an iteration, rad
  double lone_drag = 0.03;    // as Drag has it
  double first_weight = 1;    // w of the first step, over the unit of forces a step_limit
  // Newton iterations of a step, and at most so many where it would store more energy than before.
  int iterations = 3, most_iterations = 12;
  // A step ends where it leaves this share of the forces that it began with, or forces within the
  // tolerance, which is also that of rest. In the unit of forces.
  double share_left = 0.1, tolerance = 1e-3;
  // Second derivatives without what may be indefinite, far from rest; else only where exact ones
  // are indefinite.
  bool projected = true;
  // In the first step contact points stick that touch (ContactWorld::stuck_poses).
  bool sticks_first = false;
  // Contact points stay those of the first search.
  bool keeps_contacts = false;
  SearchOptions search;

  // Pace of bodies that settle.
  static Pace settling() {
    Pace pace;
    pace.together = 2;
    pace.lone_drag = 1;
    pace.iterations = pace.most_iterations = 30;
    pace.share_left = 0;
    pace.tolerance = 1e-7;
    pace.projected = false;
    pace.sticks_first = true;
    return pace;
  }
  // Pace of bodies that relax without friction beside their place, from that of their settling.
  // Faces that touch there stay those that touch, and their planes have no ends: the energy is
  // smooth, and Newton's method converges.
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
  bool at_rest = false;    // in balance under Coulomb's law when the step began: nothing moved
  bool converged = false;  // it left forces as small as Pace asks for
  int iterations = 0, factorizations = 0;
  int shortened = 0;    // how often an iteration's step was cut or halved
  double motion = 0;    // of the body that moved furthest, mm
  double energy = 0;    // after it, N mm: of the given energies and of the springs of contacts
  double residual = 0;  // largest force on a body when the step began, in the unit of forces
  // The energy before it with its own contact points (N mm), w (N / mm), what friction takes (N
  // mm).
  double before = 0, weight = 0, friction = 0;
};

class ContactWorld {
 public:
  // start: a pose for each body, in their order.
  ContactWorld(std::vector<RigidBody> bodies, Poses start, const WorldOptions& options);

  // Before the first step.
  void add(std::unique_ptr<MotionEnergy> energy) { energies_.push_back(std::move(energy)); }
  void set_friction(double coefficient) { contacts_.friction_coefficient = coefficient; }
  // From here on.
  void begin_path(const Pace& pace);
  const Pace& pace() const { return options_.pace; }
  // From here on, with friction's history between faces that stay the same.
  void set_poses(const Poses& poses);

  // No body moves past another (meeting.hpp). Throws Cancelled, with the poses as they were.
  StepReport step();
  // Until it is at rest or `enough` says so.
  StepReport settle(int max_steps, const std::function<bool(const StepReport&)>& enough = {});

  const Poses& poses() const { return poses_; }
  // Poses before anything slips (Pace::sticks_first): bodies and membranes have given way alone.
  const Poses& stuck_poses() const { return stuck_poses_; }
  double energy() const { return value(poses_); }  // N mm, as steps report it
  const std::vector<RigidBody>& bodies() const { return bodies_; }
  const ContactEnergy& contacts() const { return contacts_; }
  std::vector<TouchForce> forces() const { return contacts_.forces(poses_); }
  // What the given energies do to each body: force (N), and torque about its origin (N mm).
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
  void factorize(const Poses& x, const Drag& drag, bool& projected, StepReport& report);
  Motions newton_step(const Motions& gradient) const;
  void predict_caps(const Poses& x, const Motions& way);
  void descend(const Drag& drag, double unit, bool stuck, Poses& x, StepReport& report);

  std::vector<RigidBody> bodies_;
  Poses poses_, stuck_poses_;
  WorldOptions options_;
  std::vector<std::unique_ptr<MotionEnergy>> energies_;
  ContactEnergy contacts_;
  std::vector<int> first_;  // couplings of the energies, then those of contacts
  std::unique_ptr<BlockMatrix<6>> hessian_;
  std::optional<std::vector<std::array<int, 2>>> joined_;  // once searched
  bool searched_ = false;
  double weight_ = -1;   // w of the next step; negative: not known yet
  double rounding_ = 0;  // N: forces smaller than this are rounding of positions
};

}  // namespace curveups
