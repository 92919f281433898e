// SPDX-License-Identifier: LGPL-2.1-or-later
// Tolerances that several rooms share, each with its reason. Lengths in mm.
#pragma once

namespace curveups::tolerance {

// Violation up to which a hard constraint counts as met: a thousandth of any printer's resolution,
// and far above the rounding of coordinates of some hundred mm.
inline constexpr double constraint = 1e-6;

// Distance below which corners are merged. OpenCASCADE's own 1e-7 left slivers that made most
// solids invalid.
inline constexpr double snap = 1e-5;

// Length at the back below which interfaces have three contact points instead of four.
inline constexpr double short_interface = 0.2;

// Largest overlap of two solids that counts as none, mm3.
inline constexpr double overlap_volume = 1e-6;

// Largest coordinate, mm: a single-precision file resolves it to no less than a tile.
inline constexpr double largest_coordinate = 1e8;

}  // namespace curveups::tolerance
