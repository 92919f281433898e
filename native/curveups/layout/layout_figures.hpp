// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures how far a layout is stretched. Cuts are compared by these figures.
#pragma once

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// Of every tile: the factor by which the conformal map, the layout's start, scales it, over the
// area-weighted geometric mean of its piece; at least 1e-6, which it is where the map turned the
// tile over. Tiles can't shrink: where the map shrinks the surface, all the rest of the layout has
// to spread.
Eigen::VectorXd relative_scale(const TileMesh& tiles);

// The largest over the least.
double scale_spread(const Eigen::VectorXd& relative_scale);

// Of every contact, front and back: the membrane's length at rest between the facing pins over its
// actuated length (the ratio in Eq. 16). Above 1 it is slack.
Eigen::VectorXd spring_ratios(const DesignGeometry& geometry, const Parameters& parameters,
                              const FlatPoses& poses, const Array6& q);

struct LayoutFigures {
  double scale_spread = 1;
  double area_ratio = 1;   // flat over actuated area
  double energy = 0;       // Eq. 9 per contact: what cuts are chosen by
  double spring_mean = 0;  // of contacts and sides: the membrane's rest over its actuated length
  int slack_springs = 0;   // those above 1: no tension holds the contact on this side
};

LayoutFigures layout_figures(const DesignGeometry& geometry, const Parameters& parameters,
                             const FlatPoses& poses, const Array6& q);

}  // namespace curveups
