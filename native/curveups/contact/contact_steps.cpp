// SPDX-License-Identifier: LGPL-2.1-or-later
// Step of bodies in contact: a damped Newton method.
#include <algorithm>
#include <cmath>

#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/meeting.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

// Caps stay until the residual under them is this share of the one when they were set.
constexpr double inner_share = 0.1;

constexpr double largest_turn = 0.5;  // rad, turn of a body in an iteration

// Motion in step limits: of neighbours, `apart` against one another, and of each body by itself.
double in_step_limits(double apart, const Motions& motions, const Pace& pace, double lever) {
  const double shift = std::sqrt(motions.leftCols<3>().rowwise().squaredNorm().maxCoeff());
  const double turn = std::sqrt(motions.rightCols<3>().rowwise().squaredNorm().maxCoeff());
  return std::max({apart / pace.step_limit, shift / (pace.together * pace.step_limit),
                   turn / (largest_turn * lever)});
}

}  // namespace

double ContactWorld::stride(const Drag& drag, const Poses& to) const {
  return in_step_limits(drag.furthest_apart(to), motions_between(poses_, to, options_.lever),
                        options_.pace, options_.lever);
}

double ContactWorld::stride(const Drag& drag, const Poses& from, const Motions& motions) const {
  return in_step_limits(drag.furthest_apart(from, motions), motions, options_.pace, options_.lever);
}

// Factorizes the second derivatives at x. Where exact ones are indefinite, projected ones take
// their place from here on; a density that is not convex may need a shift all the same.
void ContactWorld::factorize(const Poses& x, const Drag& drag, bool& projected) {
  const double lone = weight_ * drag.lone();
  double shift = 0;
  while (!hessian_->factorize(0, lone + shift)) {
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

// Moves x from the step's beginning towards its minimum, where `stuck` under the caps as they are.
// Else a fixed-point iteration on the caps, c = mu N(c), which are those of the beginning at first:
// they follow the normal forces whenever x is about at the minimum under them.
void ContactWorld::descend(const Drag& drag, double unit, bool stuck, Poses& x,
                           StepReport& report) {
  const Pace& pace = options_.pace;
  const double lever = options_.lever;
  // Drift is measured from where bodies stick: those places are exact.
  const double share = stuck ? 0 : pace.share_left;
  const double goal = std::max({share * report.residual * unit, pace.tolerance * unit, rounding_});
  // Caps that have risen tighten springs by more than the step has been given.
  auto stores_more = [&] {
    const double blur = 1e-12 * (std::abs(report.before) + unit * lever);
    return value(x) - contacts_.friction_work(x) > report.before + blur;
  };
  double lagged_residual = 0;  // when caps were last set
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
    evaluate();
    bool lagged = iteration == 0;
    if (!stuck && !lagged && (last || left <= inner_share * lagged_residual)) {
      contacts_.lag_friction(x);
      evaluate();
      lagged = true;
    }
    if (lagged) lagged_residual = left;
    const bool converged = (stuck || lagged) && left <= goal;
    if (last || ((converged || stride(drag, x) > 1) && !stores_more())) break;
    ++report.iterations;
    factorize(x, drag, projected);
    const Motions way = newton_step(g);
    const double slope = g.cwiseProduct(way).sum(), blur = 1e-12 * (std::abs(now) + unit * lever);
    double part = std::min(1.0, 1 / std::max(stride(drag, x, way), 1e-300));
    report.shortened += part < 1;
    Poses next = moved(x, part * way, lever);
    for (int halved = 0; halved < 30; ++halved, ++report.shortened) {
      const bool falls =
          value(next) + drag.value(next, weight_) <= now + 1e-4 * part * slope + blur;
      if (falls && !could_pass(bodies_, poses_, next)) break;
      part /= 2;
      next = moved(x, part * way, lever);
    }
    x = std::move(next);
    checkpoint();
  }
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
    report.at_rest = true;
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
