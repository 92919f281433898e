// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a path ends: the shape that the piece has there, and the contacts that stay open.
#pragma once

#include "curveups/actuation/path.hpp"
#include "curveups/contact/virtual_scan.hpp"

namespace curveups {

struct PathEnd {
  double friction_coefficient = 0;
  bool at_rest = false;
  double energy = 0;  // N mm
  VirtualScan scan;   // of its last frame, beside the design
  // Mean distance, mm, of the last frame's front surface from that of the piece that was let go
  // where it is actuated, with the design's friction.
  double shortfall = 0;
  std::vector<std::array<int, 2>> open_contacts;  // pairs of tiles whose contact carries nothing
  // Pairs of tiles that press on one another and are no contact, the hardest first: most share a
  // corner.
  std::vector<std::array<int, 2>> wedged;
  double push = 0;  // mean normal force of the contacts, N
  int steps = 0, iterations = 0, factorizations = 0;
};

// All but the shortfall, of a path that has led the world to where it is, at this friction.
// surface: fitted_surface of its poses.
PathEnd describe_end(const ContactWorld& world, const TileMesh& tiles, const TriangleMesh& surface,
                     double friction, const ActuationPath& path);

}  // namespace curveups
