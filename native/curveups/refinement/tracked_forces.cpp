// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/tracked_forces.hpp"

#include <algorithm>

#include "curveups/bodies/bumps.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {

std::vector<Touch> find_touches(const DesignGeometry& geometry, SolvedDesign& solved) {
  std::vector<Touch> touches;
  for (Side side : {Side::front, Side::back}) {
    for (const MembraneClearance& one : find_clearances(solved, geometry, side)) {
      if (one.distance < safe_clearance) touches.push_back({one.tile, side, one.distance});
    }
  }
  return touches;
}

TrackedForces::TrackedForces(const Parameters& parameters, const Progress& progress)
    : parameters_(parameters), progress_(progress), f_min_ratio_(parameters.f_min_ratio) {}

// The contact points of one of the two problems.
std::vector<ContactPoint> TrackedForces::points_at(const DesignGeometry& geometry,
                                                   Touching where) const {
  return where == Touching::at_tips ? touch_.points : contact_corners(geometry, parameters_);
}

void TrackedForces::plan_tips(const DesignGeometry& geometry, const FlatPoses& poses) {
  const std::vector<Points3> tips =
      bump_tips(plan_bumps(geometry, poses, parameters_), geometry.tiles);
  has_tips_ = any_tips(tips);
  if (has_tips_) touch_ = tie_to_corners(contact_corners(geometry, parameters_), tips);
}

Judgement TrackedForces::judge_fresh(const Iterate& place, SolvedDesign& fresh) {
  f_min_ratio_ = fresh.f_min_ratio;
  // From the design, as verification does: what find_floor keeps is the same to the bit.
  plan_tips(place.geometry(), fit_poses(place.geometry().tiles, fresh.design.T));
  const Eigen::VectorXd normal = fresh.forces.force.col(0);
  Floors floors = no_floors;
  auto judged = [&] { return curveups::judge(normal, floors, f_min_ratio_); };
  const bool weak = judged().weak > 0;
  const Progress serial = one_at_a_time(progress_);
  std::vector<std::function<void()>> tasks;
  for (Touching where : touchings) {
    const int k = static_cast<int>(where);
    const bool exists = where == Touching::at_corners || has_tips_;
    active_[k] = active_[k] && exists;
    if (!exists || (weak && !active_[k])) continue;
    tasks.emplace_back([&, where, k] {
      BalanceSystem at =
          make_balance_system(place.geometry(), parameters_, points_at(place.geometry(), where));
      floors[k] = find_floor(fresh, where, at, serial).largest_floor;
    });
  }
  parallel_tasks(tasks);
  Judgement now = judged();
  for (Touching where : touchings) {
    if (!weak && now.is_short_of(where)) active_[static_cast<int>(where)] = true;
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
  solve_active_floors();
  for (std::size_t k = 0; k < floors_.size(); ++k) {
    if (active_[k]) {
      floor_correction_[k] = judged.floor[k] * judged.f_min - floors_[k].largest_floor;
    }
  }
}

void TrackedForces::solve_active_floors() {
  UnilateralOptions options;
  options.friction_coefficient = parameters_.friction_coefficient;
  options.scale = forces_->contact_forces().normal_mean;
  for (Touching where : touchings) {
    const int k = static_cast<int>(where);
    if (!active_[k]) continue;
    BalanceSystem system = make_balance_system(forces_->geometry(), parameters_,
                                               points_at(forces_->geometry(), where));
    const Points3 start = solve_contact_forces(system, forces_->loads()).force;
    floors_[k] = solve_unilateral(system, forces_->loads(), start, options, progress_);
  }
}

void TrackedForces::move(const Iterate& place) {
  forces_->move(place.geometry(), place.poses(), place.insets(), progress_);
  // Where a corner came or went tips are planned anew.
  if (has_tips_ && !follow_corners(contact_corners(place.geometry(), parameters_), touch_)) {
    plan_tips(place.geometry(), place.poses());
  }
}

void TrackedForces::move_back(const Iterate& place, const std::array<UnilateralResult, 2>& floors) {
  floors_ = floors;
  move(place);
}

Judgement TrackedForces::judge() {
  solve_active_floors();
  Floors floors = no_floors;
  for (std::size_t k = 0; k < floors.size(); ++k) {
    if (active_[k]) floors[k] = floors_[k].largest_floor + floor_correction_[k];
  }
  Eigen::VectorXd normal = forces_->contact_forces().force.col(0);
  // Where a contact point came or went with the vertices the next fresh mesh has to tell.
  if (normal.size() == correction_.size()) normal += correction_;
  return curveups::judge(normal, floors, f_min_ratio_);
}

std::vector<std::array<int, 2>> TrackedForces::critical_pairs(Touching where) const {
  if (!floor_is_active(where)) return {};
  const std::vector<ContactPoint> points = points_at(forces_->geometry(), where);
  std::vector<std::array<int, 2>> pairs;
  for (int p : floors_[static_cast<int>(where)].critical_points) pairs.push_back(points[p].tile);
  return pairs;
}

ForceGradient TrackedForces::gradient_of_floor(Touching where,
                                               const std::vector<VertexPatch>& vertices) const {
  const DesignGeometry& geometry = forces_->geometry();
  const BalanceSystem system =
      make_balance_system(geometry, parameters_, points_at(geometry, where));
  return floor_gradient(*forces_, system, where == Touching::at_tips ? &touch_ : nullptr,
                        floors_[static_cast<int>(where)], vertices);
}

}  // namespace curveups
