// SPDX-License-Identifier: LGPL-2.1-or-later
// Tolerances that several rooms share, each with its reason. Lengths in mm.
#pragma once

namespace curveups::tolerance {

// A hard constraint counts as met up to this: a thousandth of what any printer resolves, and far
// above the rounding of coordinates of some hundred mm.
inline constexpr double constraint = 1e-6;

// Corners nearer than this are one: OpenCASCADE's own tolerance is 1e-7, and slivers snapped only
// there gave invalid solids in most tiles.
inline constexpr double snap = 1e-5;

// Interfaces shorter than this at the back have three contact points instead of four.
inline constexpr double short_interface = 0.2;

// Overlap of two solids that counts as none, mm3.
inline constexpr double overlap_volume = 1e-6;

// Coordinates beyond this are refused, mm: a single-precision file resolves them to more than a
// tile, and squares of distances are far from the end of the numbers still.
inline constexpr double largest_coordinate = 1e8;

}  // namespace curveups::tolerance
