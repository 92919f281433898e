// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid bodies in contact under given energies, step by step: each step minimises
//   E(x) + contacts(x; c) + w |x - x0|^2 / 2
// by Newton's method on one sparse pattern, with friction limits c that each of its steps sets to
// mu times the normal forces it leads to, and remembers where friction stuck. w keeps bodies that
// nothing holds from running further than step_limit, and falls as motion ends: what comes to rest
// is at rest under E and Coulomb's law alone.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "curveups/contact/contact_energy.hpp"
#include "curveups/contact/drag.hpp"

namespace curveups {

struct WorldOptions {
  double lever = 3;       // mm: turns times this are lengths (rigid_body.hpp)
  double step_limit = 1;  // mm: about how far a body may move in a step, at most twice as far
  // w of the first step, over the unit of forces a step_limit: less where bodies start near rest.
  double first_weight = 1;
  // The unit of forces is the mean normal force, the mean given force on a body, or this where it
  // is larger, N.
  double least_unit = 0;
  // Forces left on a body, and friction beyond its cone, in that unit.
  double tolerance = 1e-7, cone_tolerance = 1e-6;
  // What a step may leave of cone_tolerance: it is taken away when the step ends, and must not wake
  // bodies that would be at rest.
  double cone_share = 0.03;
  int max_iterations = 60;  // of Newton's method, a step
  SearchOptions search;
};

// How bodies follow a path (ContactWorld::advance).
struct Pace {
  // mm: about how far bodies beside one another may move against one another in a step.
  double step_limit = 1;
  // How many times as far a body may move with those beside it.
  double together = 6;
  double largest_turn = 0.5;  // of a body in an iteration, rad
  double lone_drag = 0.03;    // as Drag has it
  // Of Newton's method, a step, and where it would store more than before: then it goes on.
  int iterations = 3, most_iterations = 12;
  double tolerance = 1e-3;  // forces left on bodies at rest, in the unit of forces
  SearchOptions search;     // on the way
};

struct StepReport {
  bool at_rest = false;                    // in balance when the step began: nothing moved
  bool converged = false;                  // the step's minimum was found, within the cone
  int iterations = 0, factorizations = 0;  // with all bodies
  double motion = 0;                       // of the body that moved furthest, mm
  double energy = 0;  // after it, N mm: of the given energies and of the springs of contacts
  double residual = 0, cone_error = 0;  // over the mean normal force
  // Of a step along a path: the energy before it with its own contact points (N mm), w (N / mm),
  // what friction takes (N mm).
  double before = 0, weight = 0, friction = 0;
};

class ContactWorld {
 public:
  // start: a pose for each body, in their order.
  ContactWorld(std::vector<RigidBody> bodies, Poses start, const WorldOptions& options);

  // Before the first step.
  void add(std::unique_ptr<MotionEnergy> energy) { energies_.push_back(std::move(energy)); }
  void set_friction(double coefficient) { contacts_.friction_coefficient = coefficient; }
  // As WorldOptions have them.
  void set_tolerances(double tolerance, double cone_tolerance, double cone_share) {
    options_.tolerance = tolerance;
    options_.cone_tolerance = cone_tolerance;
    options_.cone_share = cone_share;
  }
  const WorldOptions& options() const { return options_; }
  // To be called where second derivatives of an energy have changed.
  void energies_changed() { given_at_.clear(); }
  // From here on, with what friction remembers between faces that stay the same.
  void set_poses(const Poses& poses);

  // Other faces of the same bodies, in the same order.
  void set_bodies(std::vector<RigidBody> bodies);
  // Where bodies are and what friction remembers: to come back to.
  struct State {
    Poses poses;
    std::vector<TouchingPair> pairs;
    double weight;
  };
  State state() const { return {poses_, contacts_.pairs, weight_}; }
  void restore(State state);

  // Throws Cancelled, with the poses as they were.
  StepReport step();
  // Follows a path at this pace from here on. The way matters, not only its end: an implicit Euler
  // step of h = 1 / w under a drag of w (drag.hpp), solved by a few iterations of Newton's method
  // that never let energy rise
  // (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, IV.7). Friction's
  // limits follow the normal forces from iteration to iteration. No body moves past another
  // (meeting.hpp). at_rest: forces balance under Coulomb's law, and nothing moved.
  void begin_path(const Pace& pace);
  StepReport advance();
  // Until it is at rest, or a step was not converged, or `enough` says so.
  StepReport settle(int max_steps, const std::function<bool(const StepReport&)>& enough = {});

  const Poses& poses() const { return poses_; }
  double energy() const { return value(poses_); }  // N mm, as steps report it
  const std::vector<RigidBody>& bodies() const { return bodies_; }
  const ContactEnergy& contacts() const { return contacts_; }
  std::vector<TouchForce> forces() const { return contacts_.forces(poses_); }
  // What the given energies do to each body: force (N), and torque about its origin (N mm).
  Motions given_forces() const;

 private:
  void search();
  std::vector<std::array<int, 2>> joined_pairs() const;
  Drag make_drag() const;
  void make_pattern();
  double value(const Poses& poses) const;
  double given_gradient(const Poses& poses, Motions& out, BlockMatrix<6>* hessian) const;
  void hold_fixed(Motions& gradient) const;
  double force_unit(const Motions& given) const;
  void set_convex(double convex);
  void add_second_derivatives(const Poses& x);
  Motions newton_step(const Motions& gradient) const;
  void predict_caps(const Poses& x, const Motions& gradient);
  bool settle_worst(double weight, double scale, const Motions& gradient,
                    const Eigen::VectorXd& cone_errors, Poses& x);
  void factorize(const Poses& x, const Drag& drag, double& convex, StepReport& report);
  bool minimise(double weight, double scale, Poses& x, StepReport& report);

  std::vector<RigidBody> bodies_;
  Poses poses_;
  WorldOptions options_;
  Pace pace_;
  std::vector<std::unique_ptr<MotionEnergy>> energies_;
  ContactEnergy contacts_;
  std::vector<int> first_;  // couplings of the energies, then those of contacts
  Eigen::MatrixXd places_;          // of the bodies when the pattern was made
  std::unique_ptr<BlockMatrix<6>> hessian_;
  std::vector<std::vector<int>> joined_to_;  // each body, by this pattern; once asked for
  // Second derivatives of the given energies, where bodies were at these poses.
  Eigen::VectorXd given_entries_;
  Poses given_at_;
  std::optional<std::vector<std::array<int, 2>>> joined_;  // once searched
  bool searched_ = false;
  bool fresh_ = true;    // no step was taken yet
  bool changed_ = true;  // no step was taken with these bodies yet
  double convex_ = 0;
  double weight_ = -1;
  double rounding_ = 0;  // N: forces smaller than this are rounding of positions
};

}  // namespace curveups
