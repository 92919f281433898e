// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that follow a path: the way matters, not only its end.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/meeting.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

// Where exact second derivatives are indefinite, they leave out at least this part of what may be
// so.
constexpr double least_convex = 0.05;

}  // namespace

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
      hessian_->set_zero();
      given_gradient(x, unused, hessian_.get());
      contacts_.derivatives(x, options_.lever, unused, hessian_.get(), first_.back());
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
      report.residual = largest_motion(g) / unit;
      if (report.residual <= pace_.tolerance) {
        report.at_rest = report.converged = true;
        return report;
      }
    }
    now += drag.derivatives(x, weight_, g, hessian);
    report.converged = largest_motion(g) <= std::max(0.1 * report.residual, pace_.tolerance) * unit;
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
  report.motion = largest_motion(motions);
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
