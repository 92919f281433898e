// SPDX-License-Identifier: LGPL-2.1-or-later
// The tiles of a design that are let go where they stand when actuated. It holds where they come to
// rest, no contact is open, and friction has let the shape drift by hold_tolerance at most.
#pragma once

#include <optional>

#include "curveups/contact/tile_world.hpp"
#include "curveups/contact/virtual_scan.hpp"
#include "curveups/core/finding.hpp"

namespace curveups {

// mm: how far friction may let the shape drift, by default a hundredth of L.
double hold_tolerance(const Parameters& parameters);

class Settling {
 public:
  // bodies outlives it. pull: as make_tile_world has it. Throws what make_tile_world throws.
  Settling(const TileBodies& bodies, const SolvedDesign& solved,
           const std::array<double, 2>& pull = {1, 1});

  // Lets the tiles settle. elements: what they pull where the tiles come to rest takes the place of
  // what they pull in the actuated configuration. Once only. Throws Cancelled, what
  // TileWorld::solve_elements throws.
  void settle(double friction, SolvedDesign* elements = nullptr);

  bool at_rest() const { return at_rest_; }
  // mm: mean distance of the surface from where it is before anything slips.
  double drift() const { return drift_; }
  // Normal force of each contact, N.
  const Eigen::VectorXd& contact_force() const { return contact_force_; }
  // By how much the elements differ from what the tiles feel where they rest
  // (TileWorld::solve_elements).
  double element_change() const { return element_change_; }
  // Contacts that carry nothing, as pairs of tiles.
  std::vector<std::array<int, 2>> open_contacts() const;
  // What fails first, with the tiles that it concerns.
  std::optional<Finding> failure() const;
  bool is_known() const { return at_rest_ || drift_ > hold_tolerance_; }

  const TileWorld& tile_world() const { return built_; }
  const Points3& centres() const { return centres_; }
  TriangleMesh surface() const { return surface_at(built_.world->poses()); }
  int iterations() const { return iterations_; }
  int factorizations() const { return factorizations_; }

 private:
  bool come_to_rest();
  bool has_left() const;
  TriangleMesh surface_at(const Poses& poses) const;
  Eigen::VectorXd drifts() const;
  void measure_forces();

  const TileMesh& tiles_;
  Points3 centres_;
  TileWorld built_;
  double hold_tolerance_;
  double drift_ = 0, element_change_ = 0;
  bool at_rest_ = false;
  int iterations_ = 0, factorizations_ = 0;
  Eigen::VectorXd contact_force_;
};

}  // namespace curveups
