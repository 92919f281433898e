// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/contact_world.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "curveups/contact/meeting.hpp"
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
// Where exact second derivatives are indefinite, they leave out at least this part of what may be
// so.
constexpr double least_convex = 0.05;

double largest(const Eigen::VectorXd& values) { return values.size() > 0 ? values.maxCoeff() : 0; }

// Of a body's force and torque, or shift and turn, the larger one.
double size_of_row(const Motions& rows, int i) {
  return std::sqrt(
      std::max(rows.row(i).head<3>().squaredNorm(), rows.row(i).tail<3>().squaredNorm()));
}

double largest_row(const Motions& rows) {
  double most = 0;
  for (int i = 0; i < rows.rows(); ++i) most = std::max(most, size_of_row(rows, i));
  return most;
}

}  // namespace

ContactWorld::ContactWorld(std::vector<RigidBody> bodies, Poses start, const WorldOptions& options)
    : bodies_(std::move(bodies)), poses_(std::move(start)), options_(options) {}

void ContactWorld::set_poses(const Poses& poses) {
  poses_ = poses;
  given_at_.clear();
  searched_ = false;
  weight_ = -1;
}

void ContactWorld::set_bodies(std::vector<RigidBody> bodies) {
  changed_ = true;
  bodies_ = std::move(bodies);
  contacts_.forget_corners();
  searched_ = false;
}

void ContactWorld::restore(State state) {
  contacts_.pairs = std::move(state.pairs);
  set_poses(state.poses);
  weight_ = state.weight;
}

void ContactWorld::resume(PathState from) {
  restore(std::move(from.state));
  convex_ = from.convex;
  contacts_.coupled = std::move(from.coupled);
  places_ = std::move(from.places);
  if (places_.rows() > 0) make_pattern();
}

void ContactWorld::make_pattern() {
  std::vector<Coupling> couplings;
  first_.clear();
  for (const auto& energy : energies_) {
    first_.push_back(static_cast<int>(couplings.size()));
    energy->couple(couplings);
  }
  first_.push_back(static_cast<int>(couplings.size()));
  contacts_.couple(couplings);
  std::vector<char> free;
  std::vector<int> unknowns;  // a point does not turn
  for (const RigidBody& body : bodies_) {
    free.push_back(!body.fixed);
    unknowns.push_back(body.is_point() ? 3 : 6);
  }
  hessian_ = std::make_unique<BlockMatrix<6>>(
      std::make_shared<const BlockPattern>(free, couplings, places_), unknowns);
  given_at_.clear();
  joined_to_.clear();
}

// Bodies that the energies join, and those around a point: these depend on one another once it is
// eliminated, so that their places in the pattern cost little, and it need not change when they
// touch.
std::vector<std::array<int, 2>> ContactWorld::joined_pairs() const {
  std::vector<Coupling> couplings;
  for (const auto& energy : energies_) energy->couple(couplings);
  std::vector<std::array<int, 2>> pairs;
  auto join = [&](int i, int j) {
    if (bodies_[i].can_touch(bodies_[j])) pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  std::vector<std::vector<int>> around(bodies_.size());
  for (const auto& [i, j] : couplings) {
    if (i < 0 || j < 0 || i == j || (bodies_[i].is_point() && bodies_[j].is_point())) continue;
    if (!bodies_[i].is_point() && !bodies_[j].is_point()) {
      join(i, j);
    } else {
      const auto [point, body] = bodies_[i].is_point() ? std::pair(i, j) : std::pair(j, i);
      around[point].push_back(body);
    }
  }
  for (const std::vector<int>& list : around) {
    for (int i : list) {
      for (int j : list) {
        if (i < j) join(i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void ContactWorld::search() {
  contacts_.pairs = find_touching(bodies_, poses_, options_.search, contacts_.pairs);
  // The pattern and its order of elimination stay as long as no new pair touches.
  if (!joined_) joined_ = joined_pairs();
  if (contacts_.couple_pairs(*joined_) || !hessian_) {
    places_.resize(bodies_.size(), 3);
    for (std::size_t i = 0; i < bodies_.size(); ++i) places_.row(i) = poses_[i].t.transpose();
    make_pattern();
  }
  double stiffest = 0, furthest = 0;
  for (const TouchingPair& pair : contacts_.pairs) {
    double sum = 0;
    for (const Touch& touch : pair.touches) sum += touch.stiffness;
    stiffest = std::max(stiffest, sum);
  }
  for (const RigidMotion& pose : poses_) furthest = std::max(furthest, pose.t.norm());
  rounding_ = 1e-15 * stiffest * furthest;
  searched_ = true;
}

double ContactWorld::value(const Poses& poses) const {
  double sum = contacts_.value(poses);
  for (const auto& energy : energies_) sum += energy->value(poses);
  return sum;
}

double ContactWorld::gradient(const Poses& poses, Motions& out, BlockMatrix<6>* hessian) const {
  if (hessian) hessian->set_zero();
  double sum = given_gradient(poses, out, hessian);
  sum += contacts_.derivatives(poses, options_.lever, out, hessian, first_.back());
  hold_fixed(out);
  return sum;
}

void ContactWorld::add_second_derivatives(const Poses& x) {
  Motions unused = Motions::Zero(x.size(), 6);
  if (given_at_.empty() || contacts_.careful ||
      largest_row(motions_between(given_at_, x, options_.lever)) >
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

Motions ContactWorld::newton_step(const Motions& gradient) const {
  const Eigen::MatrixXd solved =
      hessian_->solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()));
  return Eigen::Map<const Motions>(solved.data(), gradient.rows(), 6);
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
    forces(i) = bodies_[i].fixed ? 0 : std::max(forces(i), size_of_row(gradient, i));
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
  for (int iterations = 0;;) {
    const Motions so_far = motions_between(poses_, x, lever);
    if (largest_row(so_far) > 2 * options_.step_limit) return false;
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
    const double residual = largest_row(g), error = largest(errors);
    report.residual = residual / scale;
    report.cone_error = error / scale;
    if (residual <= tolerance && error <= cone && !contacts_.glued) return true;
    if (!contacts_.is_bonded() && !contacts_.caps().allFinite() &&
        (residual <= tolerance || iterations > 0)) {
      contacts_.set_caps(contacts_.caps_at(x));
      before = -1;
      continue;
    }
    if (ask_worst && !contacts_.glued) {
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
    double part = std::min(1.0, options_.step_limit / std::max(largest_row(way), 1e-300));
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
    before = largest_row(g);
    ask_worst = true;
    factorized = whole && halved == 0;
    contacts_.careful = halved > 0;
    checkpoint();
  }
}

double ContactWorld::given_gradient(const Poses& poses, Motions& out,
                                    BlockMatrix<6>* hessian) const {
  out.setZero(poses.size(), 6);
  double energy = 0;
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    energy += energies_[k]->derivatives(poses, options_.lever, out, hessian, first_[k]);
  }
  return energy;
}

void ContactWorld::hold_fixed(Motions& gradient) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed) gradient.row(i).setZero();
  }
}

double ContactWorld::force_unit(const Motions& given) const {
  double scale = 0;
  int free = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed) continue;
    scale += given.row(i).norm();
    ++free;
  }
  scale = std::max({scale / std::max(free, 1), contacts_.mean_push(poses_), options_.least_unit});
  return scale > 0 ? scale : 1;
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
  report.residual = largest_row(g) / scale;
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
    report.motion = largest_row(motions_between(poses_, x, options_.lever));
    if (report.converged || attempt == 4) break;
    weight_ *= 8;
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

Motions ContactWorld::given_forces() const {
  Motions out = Motions::Zero(poses_.size(), 6);
  for (const auto& energy : energies_) energy->derivatives(poses_, 1, out, nullptr, 0);
  return -out;
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

void ContactWorld::begin_path(const Pace& pace) {
  pace_ = pace;
  options_.search = pace.search;
  contacts_.forget_corners();
  contacts_.careful = false;
  searched_ = false;
  convex_ = 1;
  weight_ = -1;
}

void ContactWorld::set_convex(double convex) {
  contacts_.convex = convex;
  for (const auto& energy : energies_) energy->convex = convex;
}

// Of bodies that touch or are near, and of those that the energies join. A fixed body's middle may
// be far away.
Drag ContactWorld::make_drag() const {
  std::vector<std::array<int, 2>> near, all;
  for (const TouchingPair& pair : contacts_.pairs) near.push_back(pair.body);
  std::set_union(near.begin(), near.end(), joined_->begin(), joined_->end(),
                 std::back_inserter(all));
  std::vector<Drag::Pair> pairs;
  for (const auto& [a, b] : all) {
    if (bodies_[a].fixed || bodies_[b].fixed) continue;
    pairs.push_back({{a, b}, first_.back() + contacts_.coupling({a, b})});
  }
  return {pairs, poses_, options_.lever, pace_.lone_drag};
}

// Of the second derivatives at x: as exact as they may be without being indefinite.
void ContactWorld::factorize(const Poses& x, const Drag& drag, double& convex, StepReport& report) {
  Motions unused;
  const double lone = weight_ * drag.lone();
  double extra = 0;  // a density that is not convex may need it all the same
  for (++report.factorizations; !hessian_->factorize(0, lone + extra); ++report.factorizations) {
    if (convex == 1) {
      extra = std::max(1e-4 * hessian_->mean_diagonal(), 4 * extra);
    } else {
      convex = std::clamp(2 * convex, least_convex, 1.0);
      set_convex(convex);
      gradient(x, unused, hessian_.get());
      drag.derivatives(x, weight_, unused, hessian_.get());
    }
    if (!(extra < 1e12 * (1 + weight_))) {
      throw SolverFailure("the forces on bodies in contact are not finite",
                          "check the design's parameters");
    }
  }
}

StepReport ContactWorld::advance() {
  if (!searched_) search();
  StepReport report;
  Motions g;
  double unit = 1;
  const double lever = options_.lever;
  report.before = report.energy = value(poses_);
  double convex = convex_;
  set_convex(convex);
  const Drag drag = make_drag();
  // In step limits: of neighbours against one another, or of a body.
  auto stride = [&](double apart, const Motions& motions) {
    const double shift = std::sqrt(motions.leftCols<3>().rowwise().squaredNorm().maxCoeff());
    const double turn = std::sqrt(motions.rightCols<3>().rowwise().squaredNorm().maxCoeff());
    return std::max({apart / pace_.step_limit, shift / (pace_.together * pace_.step_limit),
                     turn / (pace_.largest_turn * lever)});
  };
  auto covered = [&](const Poses& to) {
    return stride(drag.furthest_apart(to), motions_between(poses_, to, lever));
  };
  Poses x = poses_;
  // Limits of friction that have risen grip springs by more than the step has been given.
  auto stores_more = [&] {
    const double blur = 1e-12 * (std::abs(report.before) + unit * lever);
    return value(x) - contacts_.friction_work(x) > report.before + blur;
  };
  int shortened = 0;
  contacts_.careful = false;
  for (int iteration = 0;; ++iteration) {
    contacts_.set_caps(contacts_.caps_at(x));
    const bool last =
        iteration >= pace_.most_iterations || (iteration >= pace_.iterations && !stores_more());
    BlockMatrix<6>* hessian = last ? nullptr : hessian_.get();
    if (hessian) hessian->set_zero();
    double now = given_gradient(x, g, hessian);
    if (iteration == 0) {
      unit = force_unit(g);
      if (weight_ < 0) weight_ = unit / pace_.step_limit;
    }
    now += contacts_.derivatives(x, lever, g, hessian, first_.back());
    hold_fixed(g);
    if (iteration == 0) {
      report.residual = largest_row(g) / unit;
      if (report.residual <= pace_.tolerance) {
        report.at_rest = report.converged = true;
        return report;
      }
    }
    now += drag.derivatives(x, weight_, g, hessian);
    report.converged = largest_row(g) <= std::max(0.1 * report.residual, pace_.tolerance) * unit;
    if (last || ((report.converged || covered(x) > 1) && !stores_more())) break;
    ++report.iterations;
    factorize(x, drag, convex, report);
    const Motions way = newton_step(g);
    const double slope = g.cwiseProduct(way).sum(), blur = 1e-12 * (std::abs(now) + unit * lever);
    const double whole = stride(drag.furthest_apart(x, way), way);
    double part = std::min(1.0, 1 / std::max(whole, 1e-300));
    shortened += part < 1;
    bool uphill = false;
    Poses next = moved(x, part * way, lever);
    for (int halved = 0; halved < 30; ++halved, ++shortened) {
      const bool falls =
          value(next) + drag.value(next, weight_) <= now + 1e-4 * part * slope + blur;
      if (falls && !could_pass(bodies_, poses_, next)) break;
      uphill |= !falls;
      part /= 2;
      next = moved(x, part * way, lever);
    }
    contacts_.careful = uphill;
    x = std::move(next);
    checkpoint();
  }
  const Finishing finishing;
  const Motions motions = motions_between(poses_, x, lever);
  report.motion = largest_row(motions);
  report.weight = weight_;
  report.friction = contacts_.friction_work(x);
  const double distance = stride(drag.furthest_apart(x), motions);
  contacts_.remember(x);
  poses_ = std::move(x);
  searched_ = false;
  report.energy = value(poses_);
  // Steps grow where motion is slow, and hardly where a step was too long for its iterations.
  weight_ *= std::clamp(1.25 * distance, shortened > 1 ? 0.7 : 0.25, 4.0);
  weight_ = std::max(weight_, 1e-7 * unit / pace_.step_limit);
  convex_ = convex < least_convex ? 0 : convex / 1.4;
  return report;
}

}  // namespace curveups
