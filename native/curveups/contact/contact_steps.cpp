// SPDX-License-Identifier: LGPL-2.1-or-later
// One step of bodies in contact: a damped Newton method.
#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>

#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/meeting.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

// Caps stay until the residual under them is this share of what it was when they were set: a Newton
// step on the caps from farther away than that led Spot astray (1755 iterations).
constexpr double inner_share = 0.1;
// Krylov iterations of a Newton step on the caps, and their relative residual.
constexpr int most_cap_iterations = 20;
constexpr double cap_tolerance = 1e-3;

// How far bodies go, in step limits: those beside one another by `apart` against one another, each
// body by its own motion.
double in_step_limits(double apart, const Motions& motions, const Pace& pace, double lever) {
  const double shift = std::sqrt(motions.leftCols<3>().rowwise().squaredNorm().maxCoeff());
  const double turn = std::sqrt(motions.rightCols<3>().rowwise().squaredNorm().maxCoeff());
  return std::max({apart / pace.step_limit, shift / (pace.together * pace.step_limit),
                   turn / (pace.largest_turn * lever)});
}

}  // namespace

double ContactWorld::stride(const Drag& drag, const Poses& to) const {
  return in_step_limits(drag.furthest_apart(to), motions_between(poses_, to, options_.lever),
                        options_.pace, options_.lever);
}

double ContactWorld::stride(const Drag& drag, const Poses& from, const Motions& motions) const {
  return in_step_limits(drag.furthest_apart(from, motions), motions, options_.pace, options_.lever);
}

// Second derivatives at x are in the matrix. Where exact ones are indefinite, projected ones take
// their place from here on; a density that is not convex may need a shift all the same.
void ContactWorld::factorize(const Poses& x, const Drag& drag, bool& projected,
                             StepReport& report) {
  const double lone = weight_ * drag.lone();
  double shift = 0;
  for (++report.factorizations; !hessian_->factorize(0, lone + shift); ++report.factorizations) {
    if (projected) {
      shift = std::max(1e-4 * hessian_->mean_diagonal(), 4 * shift);
    } else {
      projected = true;
      Motions unused;
      hessian_->set_zero();
      derivatives(x, unused, hessian_.get(), projected);
      const MotionHessian second{hessian_.get(), 0, projected};
      drag.derivatives(x, weight_, unused, &second);
    }
    if (!(shift < 1e12 * (1 + weight_))) {
      throw SolverFailure("the forces on bodies in contact are not finite",
                          "check the design's parameters");
    }
  }
}

Motions ContactWorld::newton_step(const Motions& gradient) const {
  const Eigen::MatrixXd solved =
      hessian_->solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()));
  return Eigen::Map<const Motions>(solved.data(), gradient.rows(), 6);
}

// One Newton step on c = mu N(c), the fixed point of the friction caps c: sets them to those after
// the step d with (H + C) d = -gradient, C being the derivatives by caps that follow the normal
// forces. way: H^-1 (-gradient), by the factorization of H, which is the preconditioner.
void ContactWorld::predict_caps(const Poses& x, const Motions& way) {
  struct Operator {
    const ContactWorld& world;
    const Poses& x;
    Eigen::Index cols() const { return static_cast<Eigen::Index>(6 * x.size()); }
    Eigen::VectorXd operator*(const Eigen::VectorXd& z) const {
      const Motions motions = Eigen::Map<const Motions>(z.data(), z.size() / 6, 6);
      const Motions step =
          world.newton_step(world.contacts_.cap_derivatives(x, world.options_.lever, motions));
      return z - Eigen::Map<const Eigen::VectorXd>(step.data(), step.size());
    }
  };
  const Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXd>(way.data(), way.size());
  Eigen::VectorXd step = right;
  Eigen::Index iterations = most_cap_iterations;
  double tolerance = cap_tolerance;
  Eigen::internal::bicgstab(Operator{*this, x}, right, step, Eigen::IdentityPreconditioner(),
                            iterations, tolerance);
  contacts_.predict_friction(x, options_.lever,
                             Eigen::Map<const Motions>(step.data(), way.rows(), 6));
}

// Moves x from the step's beginning towards its minimum. stuck: under the caps as they are. Else
// caps are lagged: they stay until x is about at the minimum under them, and then follow by Newton
// steps on c = mu N(c), for as long as these lower the residual.
void ContactWorld::descend(const Drag& drag, double unit, bool stuck, Poses& x,
                           StepReport& report) {
  const Pace& pace = options_.pace;
  const double lever = options_.lever;
  const double goal =
      std::max({pace.share_left * report.residual * unit, pace.tolerance * unit, rounding_});
  // Caps that have risen tighten springs by more than the step has been given.
  auto stores_more = [&] {
    const double blur = 1e-12 * (std::abs(report.before) + unit * lever);
    return value(x) - contacts_.friction_work(x) > report.before + blur;
  };
  int shortened = 0;
  double lagged_residual = 0;  // when caps were last set to mu times the normal forces
  bool lag = !stuck;           // caps are set before the next evaluation
  for (int iteration = 0;; ++iteration) {
    const bool last =
        iteration >= pace.most_iterations || (iteration >= pace.iterations && !stores_more());
    bool projected = pace.projected;
    Motions g;
    double now = 0, left = 0;
    auto evaluate = [&] {
      BlockMatrix<6>* matrix = last ? nullptr : hessian_.get();
      if (matrix) matrix->set_zero();
      const MotionHessian second{matrix, 0, projected};
      now = derivatives(x, g, matrix, projected) +
            drag.derivatives(x, weight_, g, matrix ? &second : nullptr);
      left = largest_motion(g);
    };
    if (lag) contacts_.lag_friction(x);
    evaluate();
    const bool minimised = !stuck && !lag && (last || left <= inner_share * lagged_residual);
    if (minimised) {
      contacts_.lag_friction(x);
      evaluate();
      lag = true;
    }
    report.converged = (stuck || lag) && left <= goal;
    if (last || ((report.converged || stride(drag, x) > 1) && !stores_more())) break;
    // Where a Newton step on the caps made things worse, they stay until x is at the minimum again.
    const bool predicts = lag && iteration > 0 && (minimised || left < lagged_residual);
    if (lag) lagged_residual = left;
    ++report.iterations;
    factorize(x, drag, projected, report);
    Motions way = newton_step(g);
    if (predicts) {
      predict_caps(x, way);
      now = derivatives(x, g, nullptr, projected) + drag.derivatives(x, weight_, g, nullptr);
      way = newton_step(g);
    }
    lag = predicts;
    const double slope = g.cwiseProduct(way).sum(), blur = 1e-12 * (std::abs(now) + unit * lever);
    double part = std::min(1.0, 1 / std::max(stride(drag, x, way), 1e-300));
    shortened += part < 1;
    Poses next = moved(x, part * way, lever);
    for (int halved = 0; halved < 30; ++halved, ++shortened) {
      const bool falls =
          value(next) + drag.value(next, weight_) <= now + 1e-4 * part * slope + blur;
      if (falls && !could_pass(bodies_, poses_, next)) break;
      part /= 2;
      next = moved(x, part * way, lever);
    }
    x = std::move(next);
    checkpoint();
  }
  report.shortened = shortened;
}

StepReport ContactWorld::step() {
  if (!searched_) search();
  const Pace& pace = options_.pace;
  const double unit = force_unit();
  StepReport report;
  Motions g;
  contacts_.lag_friction(poses_);
  report.before = report.energy = derivatives(poses_, g, nullptr, false);
  report.residual = largest_motion(g) / unit;
  if (report.residual <= std::max(pace.tolerance, rounding_ / unit)) {
    report.at_rest = report.converged = true;
    if (stuck_poses_.empty()) stuck_poses_ = poses_;
    return report;
  }
  if (weight_ < 0) weight_ = pace.first_weight * unit / pace.step_limit;
  const Drag drag = make_drag();
  Poses x = poses_;
  const bool stuck = pace.sticks_first && stuck_poses_.empty();
  if (stuck) contacts_.stick(poses_);
  descend(drag, unit, stuck, x, report);

  const Finishing finishing;
  if (stuck) stuck_poses_ = x;
  report.motion = largest_motion(motions_between(poses_, x, options_.lever));
  report.weight = weight_;
  report.friction = contacts_.friction_work(x);
  const double distance = stride(drag, x);
  contacts_.remember(x);
  poses_ = std::move(x);
  searched_ = pace.keeps_contacts;
  report.energy = value(poses_);
  // Steps grow where motion is slow, and hardly where one was too long for its iterations.
  weight_ *= std::clamp(1.25 * distance, report.shortened > 1 ? 0.7 : 0.25, 4.0);
  weight_ = std::max(weight_, 1e-7 * unit / pace.step_limit);
  return report;
}

}  // namespace curveups
