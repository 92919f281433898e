// SPDX-License-Identifier: LGPL-2.1-or-later
// The tiles of a design while they settle: first as it stands, then as conditions change, each time
// from where they are. It holds where they come to rest, no contact is open, and friction has let
// the shape drift by hold_tolerance at most.
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
  // All three outlive it. Throws what make_tile_world throws.
  Settling(const Design& design, const TileBodies& bodies, const SolvedDesign& solved);
  // Tiles of their own, in the same state: for another thread.
  Settling(const Settling& other);

  // Lets the tiles settle under these conditions. First nothing slips, which shows the shape that
  // is only compressed: what friction then lets drift is counted from there, and adds up from
  // change to change. elements: of the design as it stands, what they pull where the tiles come to
  // rest takes the place of what they pull in the actuated configuration. Throws Cancelled, what
  // TileWorld::solve_elements throws.
  void settle(const Conditions& conditions, double friction, SolvedDesign* elements = nullptr);
  const Conditions& conditions() const { return built_.conditions; }
  double friction() const { return friction_; }

  // Of the last one.
  bool at_rest() const { return at_rest_; }
  double drift() const { return drift_; }  // mm
  double hold_tolerance() const { return hold_tolerance_; }
  // Normal force of each contact, N.
  const Eigen::VectorXd& contact_force() const { return contact_force_; }
  // By how much the elements differ from what the tiles feel where they rest
  // (TileWorld::solve_elements).
  double element_change() const { return element_change_; }
  // Contacts that carry nothing, as pairs of tiles.
  std::vector<std::array<int, 2>> open_contacts() const;
  bool holds() const { return !failure(); }
  // What fails first, with the tiles that it concerns.
  std::optional<Finding> failure() const;
  bool is_known() const { return at_rest_ || drift_ > hold_tolerance_; }

  // The piece as it is, to come back to.
  struct State {
    ContactWorld::State world;
    Conditions conditions;
    double friction, drift, drift_before;
    bool at_rest;
    Eigen::VectorXd contact_force;
    std::shared_ptr<const ClosestPoints> compressed;
  };
  State state() const;
  void restore(const State& state);

  const ContactWorld& world() const { return *built_.world; }
  const TileWorld& tile_world() const { return built_; }
  const Points3& centres() const { return centres_; }
  TriangleMesh surface() const;
  int iterations() const { return iterations_; }
  int factorizations() const { return factorizations_; }

 private:
  bool come_to_rest(SolvedDesign* elements = nullptr);
  bool has_left() const;
  double measured_drift() const;
  void measure_forces();

  const TileMesh& tiles_;
  Points3 centres_;
  TileWorld built_;
  double hold_tolerance_;
  double friction_ = 0, drift_ = 0, drift_before_ = 0;
  double element_change_ = 0;
  bool at_rest_ = false;
  int iterations_ = 0, factorizations_ = 0;
  Eigen::VectorXd contact_force_;
  std::shared_ptr<const ClosestPoints> compressed_;  // the surface before friction let it drift
};

}  // namespace curveups
