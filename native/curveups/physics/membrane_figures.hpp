// SPDX-License-Identifier: LGPL-2.1-or-later
// Figures of solved membranes besides their forces: slack parts, stretch, loads of the glue.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/design.hpp"
#include "curveups/physics/membrane_solution.hpp"

namespace curveups {

// Part of both membranes' rest area that is wrinkled or slack, 0 to 1.
double wrinkled_fraction(const std::array<MembraneSolution, 2>& membranes);

// Tiles beside patches of which more than a tenth is slack, ascending.
std::vector<int> tiles_beside_slack(const MembraneSolution& membrane);

// Larger principal stretch that all but this share of both membranes' rest area stays below. The
// largest of all is that of the triangle at some pin corner, a singularity (an angle of some 300
// degrees with held sides): it grows without bound as meshes get finer, this does not. 0 without
// triangles.
double stretch_of_all_but(double share, const std::array<MembraneSolution, 2>& membranes);

// Load of the glue on one pin, as the membrane pulls at the pin's outline all around. Pulls on
// opposite sides do not cancel: each is borne where it acts.
struct GlueLoad {
  int tile = -1;
  Side side = Side::front;
  double shear = 0;  // MPa: pull along the pin's top over its area
  double peel = 0;   // N / mm: pull off the top over its circumference, where it is off
};

struct GlueFigures {
  GlueLoad shear, peel;         // pins with the largest shear and the largest peel
  double limit = 0;             // MPa of shear that the glue withstands
  std::vector<int> overloaded;  // tiles with a pin beyond it, ascending
};

// q: the design's insets.
GlueFigures glue_figures(const TileMesh& tiles, const Array6& q,
                         const std::array<MembraneSolution, 2>& membranes,
                         const Parameters& parameters);

// Tension G h (1 - tau^-6) along the rim of each sheet, front and back, N/mm, stretched by tau in
// both directions and free to contract in thickness: the surplus pulls so before it is cut off
// (paper, section 6.2).
std::array<double, 2> surplus_tension(const Parameters& parameters);

}  // namespace curveups
