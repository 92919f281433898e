// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact forces of a design on its way through a repair: from a mesh that follows the tiles,
// corrected by what a fresh one, extrapolated as in verification, gave last.
#pragma once

#include <memory>
#include <vector>

#include "curveups/physics/sensitivities.hpp"
#include "curveups/refinement/iterate.hpp"
#include "curveups/refinement/judgement.hpp"

namespace curveups {

// A tile that a membrane cuts into or all but touches.
struct Touch {
  int tile;
  Side side;
  double clearance;  // mm, negative where it cuts in
};

std::vector<Touch> find_touches(const DesignGeometry& geometry, SolvedDesign& solved);

class TrackedForces {
 public:
  TrackedForces(const Parameters& parameters, const Progress& progress);

  // The verdict on a place. The largest floors are a part of it where no point is weak, and from
  // then on each where it is what fails. Throws InfeasibleDesign where the membranes don't press
  // the tiles together.
  Judgement judge_fresh(const Iterate& place, SolvedDesign& fresh);
  // Follows from here on; takes the membranes. judged: what judge_fresh said of them.
  void follow(const Iterate& place, SolvedDesign& fresh, const Judgement& judged);

  // On the moving mesh. Throws what DesignForces::move throws; then what is held is of no use until
  // the next successful move.
  void move(const Iterate& place);
  Judgement judge();
  // Back to a place that was judged, with its floors.
  void move_back(const Iterate& place, const std::array<UnilateralResult, 2>& floors);

  const DesignForces& forces() const { return *forces_; }
  const std::vector<ContactPoint>& points() const { return forces_->system().points(); }
  // f_min over the mean normal force: as asked, or the mesh's error once that is known.
  double f_min_ratio() const { return f_min_ratio_; }
  bool floor_is_active(Touching where) const { return active_[static_cast<int>(where)]; }
  // Of the last judgement, by Touching; only where active.
  const std::array<UnilateralResult, 2>& floors() const { return floors_; }
  // Tiles of the contacts that hold the floor of the last judgement down, by falling weight.
  std::vector<std::array<int, 2>> critical_pairs(Touching where) const;
  // Exact derivatives of a floor that is active.
  ForceGradient gradient_of_floor(Touching where, const std::vector<VertexPatch>& vertices) const;

 private:
  std::vector<ContactPoint> points_at(const DesignGeometry& geometry, Touching where) const;
  void solve_active_floors();
  void plan_tips(const DesignGeometry& geometry, const FlatPoses& poses);

  Parameters parameters_;
  Progress progress_;
  double f_min_ratio_;
  std::unique_ptr<DesignForces> forces_;
  TouchPoints touch_;      // at the tips; as planned last, following the corners
  bool has_tips_ = false;  // otherwise tiles touch at corners alone
  // What the fresh mesh gave beyond the moving one: normal forces and floors, N.
  Eigen::VectorXd correction_;
  Floors floor_correction_ = {0, 0};
  std::array<bool, 2> active_ = {false, false};
  std::array<UnilateralResult, 2> floors_;
};

}  // namespace curveups
