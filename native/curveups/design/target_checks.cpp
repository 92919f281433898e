// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/target_checks.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/text.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/design/joints.hpp"
#include "curveups/design/remote_overlaps.hpp"

namespace curveups {
namespace {

void sort_unique(std::vector<int>& tiles) {
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

}  // namespace

std::vector<TargetFinding> check_target(const TriangleMesh& mesh, const Edges& cuts,
                                        const Parameters& parameters) {
  std::vector<TargetFinding> findings;
  const TileMesh tiles = make_tile_mesh(mesh, cuts, parameters.H_body);
  std::vector<int> without = tiles_without_back(tiles);
  if (!without.empty()) {
    const std::string count = std::to_string(without.size());
    findings.push_back({"sharp_fold",
                        count + " tiles lie at folds sharper than a tile of thickness " +
                            number(parameters.H_body) + " mm can have: their back faces vanish",
                        "lower H_body, raise L or smooth the target there", std::move(without),
                        true});
    return findings;
  }
  Truncation truncation = truncate_at_vertices(tiles);
  std::vector<ContactPatch> patches = compute_contact_patches(tiles, truncation);
  separate_remote_tiles(tiles, patches, truncation);
  separate_remote_front_pins(tiles, parameters.H_pin, truncation);
  if (!truncation.unresolved.empty()) {
    std::vector<int> overlapping;
    for (const auto& pair : truncation.unresolved) {
      overlapping.insert(overlapping.end(), pair.begin(), pair.end());
    }
    sort_unique(overlapping);
    findings.push_back({"folded_over",
                        std::to_string(truncation.unresolved.size()) +
                            " pairs of tiles overlap in the target and no plane separates them "
                            "without losing a contact",
                        "lower H_body, or keep parts of the target farther from one another",
                        std::move(overlapping), true});
  }
  std::vector<int> hinged;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    if (patches[k].point_count == 2) {
      hinged.insert(hinged.end(), tiles.contacts[k].tile.begin(), tiles.contacts[k].tile.end());
    }
  }
  if (!hinged.empty()) {
    const std::string count = std::to_string(hinged.size() / 2);
    sort_unique(hinged);
    findings.push_back({"hinge",
                        count + " contacts are only a hinge: truncation leaves no interface",
                        "lower H_body or smooth the target there", std::move(hinged), false});
  }
  const PinBounds bounds = compute_pin_bounds(tiles, truncation, parameters);
  const Array6 beside_holes = joint_insets(tiles, parameters);
  std::vector<int> closed;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if ((beside_holes.row(i) - bounds.lower.row(i)).maxCoeff() > tolerance::constraint) {
      closed.push_back(i);
    }
  }
  if (!closed.empty()) {
    const double hole = std::floor(100 * joint_room(tiles, truncation, parameters).hole) / 100;
    findings.push_back({"joint",
                        "pins of at least A_pin_floor (" + number(parameters.A_pin_floor) +
                            " mm2) leave no room for stitching holes of " +
                            number(parameters.joint_hole) + " mm",
                        (hole > 0 ? "lower joint_hole to " + number(hole) + " or H_body"
                                  : std::string("lower H_body")) +
                            ", raise L, or set joint to none",
                        std::move(closed), true});
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
                        std::to_string(bounds.small.size()) + " pin sides can't reach A_pin_min (" +
                            number(parameters.A_pin_min) + " mm2); the smallest has " +
                            number(least) + " mm2",
                        "lower H_body, p_min or A_pin_min, raise L or smooth the target there",
                        std::move(small), false});
  }
  std::vector<int> odd;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const double mean = tiles.length.row(i).mean();
    if (mean < 0.5 * parameters.L || mean > 2 * parameters.L) odd.push_back(i);
  }
  if (!odd.empty()) {
    findings.push_back({"edge_length",
                        std::to_string(odd.size()) + " tiles are far smaller or larger than L (" +
                            number(parameters.L) + " mm)",
                        "let the target be remeshed", std::move(odd), false});
  }
  return findings;
}

namespace {

std::vector<std::string> broken_constraints(const DesignFigures& figures, double A_pin_floor) {
  const ConstraintReport& c = figures.constraints;
  std::vector<std::string> reasons;
  if (c.max_gap_violation_mm > tolerance::constraint) {
    const std::string pairs = listed(c.close_pairs, 6, pair_name);
    reasons.push_back("flat tiles are " + number(c.max_gap_violation_mm) +
                      " mm nearer than d_gap_min" + (pairs.empty() ? "" : " (" + pairs + ")"));
  }
  if (c.max_pin_bound_violation_mm > tolerance::constraint) {
    reasons.push_back("pin insets leave their bounds by " + number(c.max_pin_bound_violation_mm) +
                      " mm");
  }
  std::vector<int> small;
  for (const SmallPin& pin : c.small_pins) {
    if (pin.area < A_pin_floor) small.push_back(pin.tile);
  }
  if (!small.empty()) {
    const std::string count = std::to_string(small.size());
    sort_unique(small);
    reasons.push_back(count + " pin sides are smaller than A_pin_floor (" + tile_names(small) +
                      ")");
  }
  if (!figures.unresolved.empty()) {
    reasons.push_back(std::to_string(figures.unresolved.size()) +
                      " pairs of tiles overlap when actuated and no plane parts them (" +
                      listed(figures.unresolved, 6, pair_name) + ")");
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
