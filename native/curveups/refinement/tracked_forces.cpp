// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/tracked_forces.hpp"

#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {

namespace {
constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();
}

std::vector<Touch> find_touches(const DesignGeometry& geometry, const SolvedDesign& solved,
                                const Parameters& parameters) {
  std::vector<Touch> touches;
  for (Side side : {Side::front, Side::back}) {
    const MembraneSolution& membrane = solved.membranes[static_cast<int>(side)];
    for (const MembraneClearance& one : patch_clearances(geometry, membrane, parameters.H_pin)) {
      if (one.distance < safe_clearance) touches.push_back({one.tile, side, one.distance});
    }
  }
  return touches;
}

TrackedForces::TrackedForces(const Parameters& parameters, const RepairOptions& options,
                             const Progress& progress)
    : parameters_(parameters),
      options_(options),
      progress_(progress),
      f_min_ratio_(parameters.f_min_ratio) {}

UnilateralResult TrackedForces::unilateral(const DesignGeometry& geometry,
                                           const Wrenches& loads) const {
  BalanceSystem system = make_balance_system(geometry, parameters_);
  const ContactForces start = solve_contact_forces(system, loads);
  UnilateralOptions options;
  options.friction_coefficient = parameters_.friction_coefficient;
  options.scale = start.normal_mean;
  return solve_unilateral(system, loads, start.force, options, progress_);
}

Judgement TrackedForces::judge_fresh(const Iterate& place, const SolvedDesign& fresh) {
  f_min_ratio_ = fresh.f_min_ratio;
  const BalanceSystem system = make_balance_system(place.geometry(), parameters_);
  const Eigen::VectorXd normal = fresh.forces.force.col(0);
  auto judged = [&](bool with_floor) {
    const double floor =
        with_floor ? unilateral(place.geometry(), fresh.loads).largest_floor : not_computed;
    return curveups::judge(system.points(), normal, floor, f_min_ratio_, options_);
  };
  Judgement now = judged(floor_is_active_);
  if (now.weak == 0 && !floor_is_active_) {
    now = judged(true);
    floor_is_active_ = !now.valid();
  }
  return now;
}

void TrackedForces::follow(const Iterate& place, SolvedDesign& fresh, const Judgement& judged) {
  forces_ = std::make_unique<DesignForces>(
      place.geometry(), parameters_,
      std::array<SolvedMembrane, 2>{std::move(fresh.membranes[0].coarse),
                                    std::move(fresh.membranes[1].coarse)},
      place.poses(), place.insets());
  correction_ = judged.normal - forces_->contact_forces().force.col(0);
  if (floor_is_active_) {
    floor_ = unilateral(place.geometry(), forces_->loads());
    floor_correction_ = judged.floor * judged.f_min - floor_.largest_floor;
  }
}

void TrackedForces::move(const Iterate& place) {
  forces_->move(place.geometry(), place.poses(), place.insets(), progress_);
}

void TrackedForces::move_back(const Iterate& place, const UnilateralResult& floor) {
  floor_ = floor;
  move(place);
}

Judgement TrackedForces::judge() {
  if (floor_is_active_) floor_ = unilateral(forces_->geometry(), forces_->loads());
  const double floor = floor_is_active_ ? floor_.largest_floor + floor_correction_ : not_computed;
  Eigen::VectorXd normal = forces_->contact_forces().force.col(0);
  // Where a contact point came or went with the vertices the next fresh mesh has to tell.
  if (normal.size() == correction_.size()) normal += correction_;
  return curveups::judge(points(), normal, floor, f_min_ratio_, options_);
}

}  // namespace curveups
