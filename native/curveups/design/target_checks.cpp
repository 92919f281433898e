// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/target_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/tolerances.hpp"
#include "curveups/design/joints.hpp"
#include "curveups/design/print_constants.hpp"

namespace curveups {
namespace {

void sort_unique(std::vector<int>& tiles) {
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

template <class T>
int size_of(const std::vector<T>& items) {
  return static_cast<int>(items.size());
}

}  // namespace

std::vector<Finding> check_target(const TriangleMesh& mesh, const Edges& cuts,
                                  const Parameters& parameters) {
  std::vector<Finding> findings;
  TileMesh given = make_tile_mesh(mesh, cuts, parameters.H_body);
  const std::vector<int> without = tiles_without_back(given);
  if (!without.empty()) {
    findings.push_back({"sharp_fold",
                        without,
                        {{"count", size_of(without)}, {"H_body", parameters.H_body}},
                        true});
    return findings;
  }
  const DesignGeometry geometry = make_geometry(std::move(given), parameters);
  const TileMesh& tiles = geometry.tiles;
  const Finding::Pairs& unresolved = geometry.truncation.unresolved;
  const PinBounds& bounds = geometry.pin_bounds;
  if (!unresolved.empty()) {
    findings.push_back(
        {"folded_over", tiles_of(unresolved), {{"count", size_of(unresolved)}}, true});
  }
  Finding::Pairs hinged;
  for (std::size_t k = 0; k < geometry.patches.size(); ++k) {
    if (geometry.patches[k].point_count == 2) hinged.push_back(tiles.contacts[k].tile);
  }
  if (!hinged.empty()) {
    findings.push_back({"hinge", tiles_of(hinged), {{"count", size_of(hinged)}}});
  }
  const Array6 beside_holes = joint_insets(tiles, parameters);
  std::vector<int> closed;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if ((beside_holes.row(i) - bounds.lower.row(i)).maxCoeff() > tolerance::constraint) {
      closed.push_back(i);
    }
  }
  if (!closed.empty()) {
    findings.push_back({"joint.room",
                        std::move(closed),
                        {{"A_pin_floor", parameters.A_pin_floor}, {"joint_hole", joint_hole}},
                        true});
  }
  if (!bounds.small.empty()) {
    std::vector<int> small;
    double least = bounds.small.front().area;
    for (const SmallPin& pin : bounds.small) {
      small.push_back(pin.tile);
      least = std::min(least, pin.area);
    }
    sort_unique(small);
    findings.push_back({"small_pin",
                        std::move(small),
                        {{"count", size_of(bounds.small)},
                         {"A_pin_min", parameters.A_pin_min},
                         {"least", least}}});
  }
  std::vector<int> odd;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const double mean = tiles.length.row(i).mean();
    if (mean < 0.5 * parameters.L || mean > 2 * parameters.L) odd.push_back(i);
  }
  if (!odd.empty()) {
    findings.push_back({"edge_length", odd, {{"count", size_of(odd)}, {"L", parameters.L}}});
  }
  return findings;
}

namespace {

std::vector<Finding> broken_constraints(const DesignFigures& figures, double A_pin_floor) {
  const ConstraintReport& c = figures.constraints;
  std::vector<Finding> reasons;
  if (c.max_gap_violation_mm > tolerance::constraint) {
    reasons.push_back({c.close_pairs.empty() ? "gap.somewhere" : "gap",
                       tiles_of(c.close_pairs),
                       {{"violation", c.max_gap_violation_mm}, {"pairs", c.close_pairs}}});
  }
  if (c.max_pin_bound_violation_mm > tolerance::constraint) {
    reasons.push_back({"pin_bounds", {}, {{"violation", c.max_pin_bound_violation_mm}}});
  }
  std::vector<int> small;
  for (const SmallPin& pin : c.small_pins) {
    if (pin.area < A_pin_floor) small.push_back(pin.tile);
  }
  if (!small.empty()) {
    const int count = size_of(small);
    sort_unique(small);
    reasons.push_back({"pins_below_floor", small, {{"count", count}, {"at", small}}});
  }
  if (!figures.unresolved.empty()) {
    reasons.push_back({"overlap",
                       tiles_of(figures.unresolved),
                       {{"count", size_of(figures.unresolved)}, {"pairs", figures.unresolved}}});
  }
  return reasons;
}

}  // namespace

DesignFigures evaluate_design(const Design& design) {
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  DesignFigures figures;
  figures.contacts = static_cast<int>(geometry.tiles.contacts.size());
  for (std::size_t k = 0; k < geometry.patches.size(); ++k) {
    if (geometry.patches[k].point_count == 2) figures.hinges.push_back(static_cast<int>(k));
    figures.three_point_contacts += geometry.patches[k].point_count == 3;
  }
  figures.truncation_types = geometry.truncation.pairs_of_type;
  figures.unresolved = geometry.truncation.unresolved;
  figures.shortened = geometry.truncation.shortened;
  figures.actuated_area = geometry.tiles.area.sum();
  figures.flat_area = flat_area(geometry, design.T);
  figures.constraints = check_constraints(geometry, design.T, design.q, design.parameters);
  const Parameters& p = design.parameters;
  const double standing = p.bumps == "none" ? 0.0 : p.bump_height - 2 * wall_recess(p);
  figures.flat_clearance = p.d_gap_min - std::max(0.0, standing);
  figures.reasons = broken_constraints(figures, design.parameters.A_pin_floor);
  return figures;
}

}  // namespace curveups
