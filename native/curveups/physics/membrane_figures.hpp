// SPDX-License-Identifier: LGPL-2.1-or-later
// What a solved membrane is judged by besides its forces: where it is slack, how far it is
// stretched and what it asks of the glue that holds it.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/design.hpp"
#include "curveups/physics/membrane_solution.hpp"

namespace curveups {

// Rest areas of one side's membrane, all of it and by patch of its domain, mm2.
struct MembraneAreas {
  double all = 0, wrinkled = 0, slack = 0;  // wrinkled: or slack
  std::vector<double> patch, slack_patch;
};

MembraneAreas measure_areas(const MembraneSolution& membrane);

// Tiles beside patches of which more than a tenth is slack, ascending.
std::vector<int> tiles_beside_slack(const MembraneSolution& membrane, const MembraneAreas& areas);

// The larger principal stretch that all but this share of both membranes' rest area stays below.
// The largest of all is that of the triangle at some pin corner, a singularity (an angle of some
// 300 degrees with held sides): it grows without bound as meshes get finer, this does not. 0
// without triangles.
double stretch_of_all_but(double share, const std::array<MembraneSolution, 2>& membranes);

// What the glue on one pin holds, as the membrane pulls at the pin's outline all around. Pulls on
// opposite sides do not cancel: each is carried where it acts.
struct GlueLoad {
  int tile = -1;
  Side side = Side::front;
  double shear = 0;  // MPa: pull along the pin's top over its area
  double peel = 0;   // N / mm: pull off the top over its circumference, where it is off
  double limit = 0;  // MPa of shear that the glue withstands there
};

// Loads of every pin, by side and tile. q: the design's insets.
using GlueLoads = std::array<std::vector<GlueLoad>, 2>;
GlueLoads glue_loads(const TileMesh& tiles, const Array6& q,
                     const std::array<MembraneSolution, 2>& membranes,
                     const Parameters& parameters);

// The pin nearest to its limit or furthest beyond it, and that with the largest peel.
struct LargestGlueLoads {
  GlueLoad shear, peel;
};
LargestGlueLoads largest_of(const GlueLoads& loads);

// Tiles with a pin whose glue carries more shear than it withstands, ascending.
std::vector<int> overloaded_tiles(const GlueLoads& loads);

// N/mm along the rim of each sheet, front and back, stretched by tau in both directions and free
// to contract in thickness: the surplus pulls so before it is cut off (paper, section 6.2).
std::array<double, 2> surplus_tension(const Parameters& parameters);

}  // namespace curveups
