// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/tracked_forces.hpp"

#include <cmath>

namespace curveups {

TrackedForces::TrackedForces(const Parameters& parameters, const Progress& progress)
    : parameters_(parameters), progress_(progress), f_min_ratio_(parameters.f_min_ratio) {}

Judgement TrackedForces::judge_fresh(const Iterate& place, const SolvedDesign& fresh,
                                     double floor) {
  f_min_ratio_ = fresh.f_min_ratio;
  if (std::isnan(floor) && active_) {
    BalanceSystem system = make_balance_system(place.geometry(), parameters_);
    floor = find_floor(fresh, system, progress_).largest_floor;
  }
  Judgement now = curveups::judge(fresh.forces.force.col(0), floor, f_min_ratio_);
  active_ = active_ || now.is_short_of_floor();
  return now;
}

void TrackedForces::follow(const Iterate& place, const SolvedDesign& fresh,
                           const Judgement& judged) {
  forces_ = std::make_unique<DesignForces>(
      place.geometry(), parameters_,
      std::array<SolvedMembrane, 2>{fresh.membranes[0].coarse, fresh.membranes[1].coarse},
      place.poses(), place.insets());
  correction_ = judged.normal - forces_->contact_forces().force.col(0);
  solve_active_floor();
  if (active_) floor_correction_ = judged.floor * judged.f_min - floor_.largest_floor;
}

void TrackedForces::solve_active_floor() {
  if (!active_) return;
  const ContactForces& start = forces_->contact_forces();
  const UnilateralOptions options = {parameters_.friction_coefficient, start.normal_mean};
  BalanceSystem system = make_balance_system(forces_->geometry(), parameters_);
  floor_ = solve_unilateral(system, forces_->loads(), start.force, options, progress_);
}

void TrackedForces::move(const Iterate& place) {
  forces_->move(place.geometry(), place.poses(), place.insets(), progress_);
}

void TrackedForces::move_back(const Iterate& place, const UnilateralResult& floor) {
  floor_ = floor;
  move(place);
}

Judgement TrackedForces::judge() {
  solve_active_floor();
  const double floor = active_ ? floor_.largest_floor + floor_correction_ : no_floor;
  Eigen::VectorXd normal = forces_->contact_forces().force.col(0);
  // The correction waits for a fresh mesh where a contact point came or went with the vertices.
  if (normal.size() == correction_.size()) normal += correction_;
  return curveups::judge(normal, floor, f_min_ratio_);
}

std::vector<std::array<int, 2>> TrackedForces::critical_pairs() const {
  std::vector<std::array<int, 2>> pairs;
  if (!active_) return pairs;
  for (int p : floor_.critical_points) pairs.push_back(points()[p].tile);
  return pairs;
}

}  // namespace curveups
