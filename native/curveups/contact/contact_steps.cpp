// SPDX-License-Identifier: LGPL-2.1-or-later
// One step of bodies in contact: a damped Newton method.
#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/meeting.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

// Part of Newton's step that is taken at least where caps that follow normal forces overshoot.
constexpr double least_damping = 1.0 / 16;

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

// Moves x from the step's beginning towards its minimum. stuck: under the caps as they are, else
// under caps that follow the normal forces.
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
  double damping = 1, before = std::numeric_limits<double>::infinity();
  for (int iteration = 0;; ++iteration) {
    if (!stuck) contacts_.lag_friction(x);
    bool projected = pace.projected;
    const bool last =
        iteration >= pace.most_iterations || (iteration >= pace.iterations && !stores_more());
    Motions g;
    BlockMatrix<6>* matrix = last ? nullptr : hessian_.get();
    if (matrix) matrix->set_zero();
    const MotionHessian second{matrix, 0, projected};
    const double now = derivatives(x, g, matrix, projected) +
                       drag.derivatives(x, weight_, g, matrix ? &second : nullptr);
    const double left = largest_motion(g);
    report.converged = left <= goal;
    if (left <= (1 - 0.5 * damping) * before) {
      damping = std::min(2 * damping, 1.0);
    } else if (left > before && !stuck) {
      damping = std::max(0.5 * damping, least_damping);
    }
    before = left;
    if (last || ((report.converged || stride(drag, x) > 1) && !stores_more())) break;
    ++report.iterations;
    factorize(x, drag, projected, report);
    const Motions way = newton_step(g);
    const double slope = g.cwiseProduct(way).sum(), blur = 1e-12 * (std::abs(now) + unit * lever);
    double part = std::min(damping, 1 / std::max(stride(drag, x, way), 1e-300));
    shortened += part < damping;
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
  searched_ = false;
  report.energy = value(poses_);
  // Steps grow where motion is slow, and hardly where one was too long for its iterations.
  weight_ *= std::clamp(1.25 * distance, report.shortened > 1 ? 0.7 : 0.25, 4.0);
  weight_ = std::max(weight_, 1e-7 * unit / pace.step_limit);
  return report;
}

}  // namespace curveups
