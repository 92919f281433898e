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

std::vector<Touch> find_touches(const DesignGeometry& geometry, const SolvedDesign& solved);

class TrackedForces {
 public:
  TrackedForces(const Parameters& parameters, const Progress& progress);

  // The verdict on a place. The largest floor is a part of it where no point is weak, and from then
  // on where it is what fails. Throws InfeasibleDesign where the membranes don't press the tiles
  // together.
  Judgement judge_fresh(const Iterate& place, const SolvedDesign& fresh);
  // Follows from here on. judged: what judge_fresh said of it.
  void follow(const Iterate& place, const SolvedDesign& fresh, const Judgement& judged);

  // On the moving mesh. Throws what DesignForces::move throws; then what is held is of no use until
  // the next successful move.
  void move(const Iterate& place);
  Judgement judge();
  // Back to a place that was judged, with its floor.
  void move_back(const Iterate& place, const UnilateralResult& floor);

  const DesignForces& forces() const { return *forces_; }
  const std::vector<ContactPoint>& points() const { return forces_->system().points(); }
  // f_min over the mean normal force: as asked, or the mesh's error once that is known.
  double f_min_ratio() const { return f_min_ratio_; }
  bool floor_is_active() const { return active_; }
  // The unilateral problem of the last judgement; only where active.
  const UnilateralResult& floor() const { return floor_; }
  // Tiles of the contacts that hold the floor of the last judgement down, by falling weight.
  std::vector<std::array<int, 2>> critical_pairs() const;

 private:
  void solve_active_floor();

  Parameters parameters_;
  Progress progress_;
  double f_min_ratio_;
  std::unique_ptr<DesignForces> forces_;
  // Difference of the fresh mesh from the moving one: normal forces and floor, N.
  Eigen::VectorXd correction_;
  double floor_correction_ = 0;
  bool active_ = false;  // whether the floor is a part of judgements
  UnilateralResult floor_;
};

}  // namespace curveups
