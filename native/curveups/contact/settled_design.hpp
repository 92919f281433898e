// SPDX-License-Identifier: LGPL-2.1-or-later
// Settled forces: forces that develop where a design's tiles are let go in the actuated
// configuration, with Coulomb friction, and the shape that the piece then has (the virtual scan).
// The verdict (verdict.hpp) asks for forces that could balance; these are the ones that do.
#pragma once

#include "curveups/contact/process_window.hpp"
#include "curveups/contact/tile_world.hpp"
#include "curveups/contact/virtual_scan.hpp"
#include "curveups/core/progress.hpp"
#include "curveups/physics/friction_needed.hpp"
#include "curveups/physics/margin.hpp"

namespace curveups {

struct SettledTiles {
  bool converged = false;  // at rest under membranes, contacts and Coulomb's law
  // Mean distance, mm, of the front surface from where it is while nothing slips: tiles and bumps
  // give way there as well, but friction holds.
  double drift = 0;
  // First reason why the tiles do not hold: they drift by more than the tolerance, do not come to
  // rest, or leave contacts open.
  std::optional<Finding> failure;
  // Unknown where tiles neither come to rest nor drift further than the tolerance.
  std::optional<bool> holds;
  Eigen::VectorXd contact_force;                  // normal, N, per contact
  std::vector<std::array<int, 2>> open_contacts;  // pairs of tiles whose contact carries nothing
  // Force, or torque over L, by which the membranes' finite elements with the pins where they have
  // settled differ from those in the world, over the mean force on a tile; 0: not at rest.
  double element_change = 0;
  int iterations = 0;
};

// Lets the tiles of a world settle under this friction. elements: the solution whose forces in the
// actuated configuration give way to those where the tiles come to rest; else null. Throws
// Cancelled, what TileWorld::solve_elements throws.
SettledTiles settle_tiles(TileWorld& tiles, const TileBodies& bodies, double friction,
                          SolvedDesign* elements = nullptr);

struct SettledDesign : SettledTiles {
  double friction_coefficient = 0;
  double hold_tolerance = 0;               // mm
  double normal_mean = 0, normal_min = 0;  // N, over the contacts
  double largest_slip = 0;                 // mm, of a point that pushes
  VirtualScan scan;                        // beside the design's actuated surface
  Margin margin;                           // by forces that could balance, not by settling
  FrictionNeeded friction_needed;          // likewise
  std::vector<WindowRange> window;         // where the parameters ask for it and the design holds
  std::optional<double> holding_friction;  // the window's least friction
  Eigen::VectorXd deviation;               // per tile, mean of its samples, mm
};

// Settles a design under its own parameters. solved: solve_design's of these tiles, pins and
// membranes, where it is known; else null. Throws what make_tile_bodies and solve_design throw,
// Cancelled.
SettledDesign settle_design(const Design& design, const Progress& progress,
                            const SolvedHandle& solved = nullptr);

}  // namespace curveups
