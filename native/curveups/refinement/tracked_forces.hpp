// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact forces of a design on its way through a repair, from a mesh that follows the tiles. They
// are corrected by their difference from those on the last fresh mesh, extrapolated as in
// verification: without that, Turtle ends invalid.
#pragma once

#include <memory>
#include <vector>

#include "curveups/physics/sensitivities.hpp"
#include "curveups/refinement/iterate.hpp"
#include "curveups/refinement/judgement.hpp"

namespace curveups {

class TrackedForces {
 public:
  TrackedForces(const Parameters& parameters, const Progress& progress);

  // Judges a place on a fresh mesh. floor: the largest one, N, or no_floor; it is computed then
  // where it was too small before. Throws InfeasibleDesign where the membranes don't press the
  // tiles together.
  Judgement judge_fresh(const Iterate& place, const SolvedDesign& fresh, double floor);
  // Follows the tiles from here on. judged: by judge_fresh.
  void follow(const Iterate& place, const SolvedDesign& fresh, const Judgement& judged);

  // Moves the mesh. Throws what DesignForces::move throws; then the forces are invalid until the
  // next successful move.
  void move(const Iterate& place);
  // Judges the place of the mesh.
  Judgement judge();
  // Moves back to a place that was judged, with its floor.
  void move_back(const Iterate& place, const UnilateralResult& floor);

  const DesignForces& forces() const { return *forces_; }
  const std::vector<ContactPoint>& points() const { return forces_->system().points(); }
  bool floor_is_active() const { return active_; }
  // Unilateral problem of the last judgement; only where active.
  const UnilateralResult& floor() const { return floor_; }
  // Tiles of the contacts that bound the floor of the last judgement, by falling weight.
  std::vector<std::array<int, 2>> critical_pairs() const;

 private:
  void solve_active_floor();

  Parameters parameters_;
  Progress progress_;
  double f_min_ratio_;  // f_min over the mean force: as asked, or the mesh's error once known
  std::unique_ptr<DesignForces> forces_;
  // Difference of the fresh mesh from the moving one, N: normal forces and floor.
  Eigen::VectorXd correction_;
  double floor_correction_ = 0;
  bool active_ = false;  // judgements include the floor
  UnilateralResult floor_;
};

}  // namespace curveups
