// SPDX-License-Identifier: LGPL-2.1-or-later
// Energies and constraints of the layout, on the unknowns of one tile or of two. To add one: a
// file, a line here and a line in layout_terms.cpp.
#pragma once

#include <cmath>
#include <map>
#include <string>

#include "curveups/layout/layout_model.hpp"
#include "curveups/numerics/interior_point.hpp"

namespace curveups {

// Weights of alignment, packing and springs in Eq. 9, those of the paper's figures.
inline constexpr double w_a = 30, w_p = 30, w_s = 1;

using LayoutTerm = Residuals;
using LayoutTerms = ResidualsList;

// Residuals of Eq. 9, weighted: E = sum of squares, twice the terms' values. The terms refer to the
// model.
LayoutTerms make_energies(const LayoutModel& model);

// Hard constraints, mm: every element must be at least 0. Bounds of insets are not among them;
// inset_bounds has them.
LayoutTerms make_constraints(const LayoutModel& model);
std::vector<Bound> inset_bounds(const LayoutModel& model);

// Each term's share of Eq. 9, by name.
std::map<std::string, double> energies_by_name(const LayoutTerms& terms, const LayoutState& state);

// Terms, each in a file of its name.
std::unique_ptr<LayoutTerm> make_alignment_energy(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_packing_energy(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_spring_energy(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_gap_constraint(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_pin_area_constraint(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_pin_keepout_constraint(const LayoutModel& model);

// The pose among a tile's unknowns.
struct PlacedTile {
  explicit PlacedTile(const double* unknowns)
      : middle(unknowns[0], unknowns[1]), turn(unknowns[2]), insets(unknowns + 3) {}
  Vec2 middle;
  PlaneRotation turn;
  const double* insets;
};

// A point fixed to the tile: derivatives by x and y are the unit vectors, by the angle `by_angle`.
struct PlacedPoint {
  PlacedPoint(const PlacedTile& tile, const Vec2& local)
      : offset(tile.turn * local), position(tile.middle + offset), by_angle(left_of(offset)) {}
  Vec2 offset, position, by_angle;
};

// B of Eq. 16, mm: the distance of the facing pin edges at the pins' ends, of insets q1 and q2 and
// half the fold (negated on the back), with its derivatives by the insets.
struct SpringLength {
  double length, by_q1, by_q2;
};

inline SpringLength spring_length(double q1, double q2, double half_dihedral, double H_pin) {
  const double c = std::cos(half_dihedral), s = std::sin(half_dihedral);
  const double wide = (q1 + q2) * c + 2 * H_pin * s, high = (q1 - q2) * s;
  const double length = std::sqrt(wide * wide + high * high);
  return {length, (wide * c + high * s) / length, (wide * c - high * s) / length};
}

}  // namespace curveups
