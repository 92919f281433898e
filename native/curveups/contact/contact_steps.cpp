// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that settle: each step ends in the minimum of the energies under Coulomb's law.
#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/contact/contact_world.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/numerics/anderson.hpp"

namespace curveups {
namespace {

// Limits of friction are predicted where the forces that are left are at most so many times what
// friction is beyond its cone by. Further from rest a prediction is a leap: a wedge that would hold
// ends beside its groove.
constexpr double predictable = 10;
// They are predicted until what they are wrong by has fallen to this share of what it
// was at first, or so many times.
constexpr double predicted_share = 0.1;
constexpr int most_predictions = 6;
// Second derivatives of the given energies serve until a body has moved by this share of the
// largest step, or an iteration's step had to be halved: membranes hardly change, contacts do.
constexpr double kept_share = 0.1;
// Iterations in which a few bodies that hold the rest up find rest by themselves, or are left
// alone.
constexpr int most_alone = 20;
// Iterations in a row that have not halved the forces that are left. After the first number no
// bodies find rest by themselves until they are halved: what a few do and what all do then can undo
// one another for hundreds of iterations. After the second the step ends unconverged.
constexpr int stalled_without_parts = 6, most_stalled = 50;

double largest(const Eigen::VectorXd& values) { return values.size() > 0 ? values.maxCoeff() : 0; }

}  // namespace

void ContactWorld::add_second_derivatives(const Poses& x) {
  Motions unused = Motions::Zero(x.size(), 6);
  if (given_at_.empty() || contacts_.careful ||
      largest_motion(motions_between(given_at_, x, options_.lever)) >
          kept_share * options_.step_limit) {
    hessian_->set_zero();
    given_gradient(x, unused, hessian_.get());
    given_entries_ = hessian_->entries();
    given_at_ = x;
  } else {
    hessian_->set_entries(given_entries_);
  }
  contacts_.derivatives(x, options_.lever, unused, hessian_.get(), first_.back());
}

// Limits of friction that are mu times the normal forces after the very step that they lead to, to
// first order: Newton's method on Coulomb's law. Its matrix is not symmetric; the factorization of
// the symmetric part and Anderson's method solve with it, also where a wedge would make the plain
// iteration run away.
void ContactWorld::predict_caps(const Poses& x, const Motions& gradient) {
  Eigen::VectorXd caps = contacts_.caps();
  AndersonIteration fixed_point;
  double first = 0;
  for (int k = 0; k < most_predictions; ++k) {
    Motions changed = gradient;
    contacts_.add_caps(x, options_.lever, caps, changed);
    hold_fixed(changed);
    const Eigen::VectorXd wanted = contacts_.caps_after(x, options_.lever, newton_step(changed));
    const double error = (wanted - caps).lpNorm<Eigen::Infinity>();
    if (k == 0) first = error;
    if (error <= predicted_share * first) {
      caps = wanted;
      break;
    }
    caps = fixed_point.next(caps, wanted).cwiseMax(0.0);
  }
  contacts_.set_caps(caps);
}

// Lets a few bodies that hold the rest up settle by themselves (body_part.hpp), with their limits
// of friction. False where there are no such bodies, or they find no rest.
bool ContactWorld::settle_worst(double weight, double scale, const Motions& gradient,
                                const Eigen::VectorXd& cone_errors, Poses& x) {
  if (joined_to_.empty()) {
    std::vector<Coupling> couplings;
    for (const auto& energy : energies_) energy->couple(couplings);
    contacts_.couple(couplings);
    joined_to_.resize(bodies_.size());
    for (const auto& [i, j] : couplings) {
      if (i < 0 || j < 0) continue;
      joined_to_[i].push_back(j);
      joined_to_[j].push_back(i);
    }
  }
  Eigen::VectorXd forces = cone_errors;
  for (int i = 0; i < gradient.rows(); ++i) {
    forces(i) = bodies_[i].fixed ? 0 : std::max(forces(i), size_of_motion(gradient, i));
  }
  const BodyPart part = worst_part(forces, bodies_, joined_to_);
  if (part.moving == 0) return false;
  std::vector<RigidBody> bodies;
  Poses start, places;
  for (int body : part.bodies) {
    // Only points are without faces.
    bodies.push_back({std::vector<BodySurface>(bodies_[body].is_point() ? 0 : 1),
                      static_cast<int>(start.size()) >= part.moving});
    start.push_back(poses_[body]);
    places.push_back(x[body]);
  }
  WorldOptions options = options_;
  options.max_iterations = most_alone;
  ContactWorld alone(std::move(bodies), std::move(start), options);
  for (const auto& energy : energies_) alone.add(energy->part(part));
  alone.contacts_ = static_cast<const ContactEnergy&>(*contacts_.part(part));
  alone.make_pattern();
  alone.rounding_ = rounding_;
  alone.changed_ = false;
  StepReport report;
  if (!alone.minimise(weight, scale, places, report)) return false;
  for (int k = 0; k < part.moving; ++k) x[part.bodies[k]] = places[k];
  contacts_.take_caps(alone.contacts_, part);
  return true;
}

bool ContactWorld::minimise(double weight, double scale, Poses& x, StepReport& report) {
  // What is left of friction beyond the cone is taken away when the step ends, and must not wake
  // bodies that would be at rest: they would creep from step to step.
  const double tolerance = std::max(options_.tolerance * scale, rounding_),
               cone = options_.cone_share * options_.cone_tolerance * scale;
  const double lever = options_.lever;
  contacts_.careful = false;
  Motions given, g;
  double given_energy = given_gradient(x, given, nullptr);
  double before = -1;  // the residual before the last step, where it was a whole one
  bool factorized = false;
  double shift = 0;
  bool ask_worst = true;  // since the last step nobody did
  double best = std::numeric_limits<double>::infinity();
  int stalled = 0;
  for (int iterations = 0;;) {
    const Motions so_far = motions_between(poses_, x, lever);
    if (largest_motion(so_far) > 2 * options_.step_limit) return false;
    // Under the present limits of friction, with its gradient.
    const auto energy_here = [&] {
      g = given + weight * so_far;
      const double energy = given_energy + 0.5 * weight * so_far.squaredNorm() +
                            contacts_.derivatives(x, lever, g, nullptr, first_.back());
      hold_fixed(g);
      return energy;
    };
    contacts_.glued = contacts_.is_bonded() && changed_ && iterations == 0;
    double now = energy_here();
    const Eigen::VectorXd errors = contacts_.cone_errors(x);
    const double residual = largest_motion(g), error = largest(errors);
    report.residual = residual / scale;
    report.cone_error = error / scale;
    if (residual <= tolerance && error <= cone && !contacts_.glued) return true;
    if (!contacts_.is_bonded() && !contacts_.caps().allFinite() &&
        (residual <= tolerance || iterations > 0)) {
      contacts_.set_caps(contacts_.caps_at(x));
      before = -1;
      continue;
    }
    if (ask_worst && !contacts_.glued && stalled < stalled_without_parts) {
      ask_worst = false;
      if (settle_worst(weight, scale, g, errors, x)) {
        given_energy = given_gradient(x, given, nullptr);
        continue;
      }
    }
    // By an older factorization where that contracts well.
    const bool fresh = !factorized;
    if (!fresh && before > 0 && residual > 0.2 * before) {
      factorized = false;
      before = -1;
      continue;
    }
    const double left = std::max(residual, error);
    if (left < 0.5 * best) {
      best = left;
      stalled = 0;
    } else if (++stalled == most_stalled) {
      return false;
    }
    if (++iterations > options_.max_iterations) return false;
    ++report.iterations;
    if (fresh) {
      ++report.factorizations;
      add_second_derivatives(x);
      double extra = shift;
      while (!hessian_->factorize(0, weight + extra)) {
        extra = std::max(1e-4 * hessian_->mean_diagonal(), 4 * extra);
        if (!(extra < 1e12 * (1 + weight))) {
          throw SolverFailure("the forces on bodies in contact are not finite",
                              "check the design's parameters");
        }
      }
      shift = extra / 16;
      if (shift < 1e-7 * hessian_->mean_diagonal()) shift = 0;
      factorized = true;
    }
    if (error > cone && residual <= std::max(tolerance, predictable * error) &&
        contacts_.caps().allFinite()) {
      predict_caps(x, g);
      now = energy_here();
    }
    const Motions way = newton_step(g);
    double part = std::min(1.0, options_.step_limit / std::max(largest_motion(way), 1e-300));
    const double slope = g.cwiseProduct(way).sum();
    const bool whole = part == 1;
    // Below what rounding leaves of the energy, descent can't be seen: the step is taken.
    const double blur = 1e-12 * (std::abs(now) + scale * lever);
    int halved = 0;
    for (;; part /= 2, ++halved) {
      Poses next = moved(x, part * way, lever);
      given_energy = given_gradient(next, given, nullptr);
      const double energy = given_energy + contacts_.value(next) +
                            0.5 * weight * motions_between(poses_, next, lever).squaredNorm();
      if (energy <= now + 1e-4 * part * slope + blur || halved == 30) {
        x = std::move(next);
        break;
      }
    }
    contacts_.glued = false;
    before = largest_motion(g);
    ask_worst = true;
    factorized = whole && halved == 0;
    contacts_.careful = halved > 0;
    checkpoint();
  }
}

StepReport ContactWorld::step() {
  contacts_.glued = false;  // where the last one was interrupted
  if (!searched_) search();
  StepReport report;
  Motions g(poses_.size(), 6), given;
  double energy = given_gradient(poses_, given, nullptr);
  const double scale = force_unit(given);
  g = given;
  energy += contacts_.derivatives(poses_, options_.lever, g, nullptr, first_.back());
  hold_fixed(g);
  report.residual = largest_motion(g) / scale;
  report.cone_error = largest(contacts_.cone_errors(poses_)) / scale;
  report.energy = energy;
  if (report.residual <= std::max(options_.tolerance, rounding_ / scale) &&
      report.cone_error <= options_.cone_tolerance) {
    report.at_rest = report.converged = true;
    return report;
  }

  if (weight_ < 0) weight_ = options_.first_weight * scale / options_.step_limit;
  if (contacts_.is_bonded()) {
    contacts_.bond(poses_);
  } else if (fresh_) {
    contacts_.stick();
  }
  Poses x;
  for (int attempt = 0;; ++attempt) {
    x = poses_;
    report.converged = minimise(weight_, scale, x, report);
    report.motion = largest_motion(motions_between(poses_, x, options_.lever));
    if (report.converged || attempt == 4) break;
    weight_ *= 64;  // an attempt that fails is dear, one that moves less than it could is not
  }
  fresh_ = changed_ = false;
  contacts_.remember(x);
  poses_ = std::move(x);
  searched_ = false;
  report.energy = value(poses_);
  weight_ *= std::clamp(2 * report.motion / options_.step_limit, 1e-3, 4.0);
  weight_ = std::max(weight_, 1e-7 * scale / options_.step_limit);
  return report;
}

StepReport ContactWorld::settle(int max_steps,
                                const std::function<bool(const StepReport&)>& enough) {
  StepReport report;
  for (int k = 0; k < max_steps; ++k) {
    report = step();
    if (report.at_rest || (enough && enough(report))) break;
  }
  return report;
}

}  // namespace curveups
