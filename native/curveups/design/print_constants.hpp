// SPDX-License-Identifier: LGPL-2.1-or-later
// Sizes of a print that are the same in every design, mm.
#pragma once

namespace curveups {

// From pins to facing pins and to truncation planes at sharp folds: a line of a fine printer.
inline constexpr double pin_clearance = 0.05;

// Diameter of a friction bump at its wall over its height: 1 mm for the usual 0.25 mm.
inline constexpr double bump_aspect = 4;

// Between a bump and its dimple: the growth of two printed walls.
inline constexpr double dimple_clearance = 0.1;

// Diameter of a stitching hole: a strong needle passes.
inline constexpr double joint_hole = 1.0;

// Width of the slab around tiles and anchors: a wall that stands while the slab dissolves.
inline constexpr double support_margin = 2.0;

// From the outline of the layout to the anchors: room for the slab's wall between them.
inline constexpr double anchor_distance = 3.0;

// Between the axes of neighbouring anchors: 6 mm of bare membrane between anchors of 8 mm.
inline constexpr double anchor_spacing = 14.0;

// Width of a breakaway bridge: two lines of a 0.4 mm nozzle.
inline constexpr double bridge_width = 0.8;

// Depth to which a breakaway bridge enters each body, so that they print as one.
inline constexpr double bridge_depth = 0.2;

}  // namespace curveups
