// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/design/joints.hpp"
#include "curveups/design/membrane_clearance.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double least_scale = 1e-6;

template <class T>
int size_of(const std::vector<T>& items) {
  return static_cast<int>(items.size());
}

double dihedral_margin(const TileMesh& tiles, int i, int t, double scale) {
  const double spare = 2 * tiles.area(i) * scale / (tiles.length(i, t) * tiles.H_body);
  const double half = 0.5 * tiles.dihedral(i, t);
  return 2 * (std::atan(std::tan(half) + spare) - half);
}

PerSide membrane_clearance(const TileMesh& tiles, const Array6& lower, double H_pin) {
  PerSide out = PerSide::Constant(tiles.tile_count(), 2, H_pin);
  const auto lessen = [&](int tile, Side side, double clearance) {
    double& value = out(tile, static_cast<int>(side));
    value = std::min(value, clearance);
  };
  const std::vector<std::vector<int>> around = tiles_around_inner_vertices(tiles);
  for (Side side : {Side::front, Side::back}) {
    for (std::size_t v = 0; v < around.size(); ++v) {
      const std::vector<double> clearances =
          corner_clearances(tiles, lower, H_pin, side, static_cast<int>(v), around[v]);
      for (std::size_t k = 0; k < clearances.size(); ++k) lessen(around[v][k], side, clearances[k]);
    }
    for (const Contact& contact : tiles.contacts) {
      const double dihedral = tiles.dihedral(contact.tile[0], contact.side[0]);
      for (int s = 0; s < 2; ++s) {
        const double q = lower(contact.tile[s], inset_index(side, contact.side[s]));
        lessen(contact.tile[s], side, edge_clearance(dihedral, side, q, H_pin));
      }
    }
  }
  return out;
}

void add_shapes(const DesignGeometry& geometry, const Parameters& p, TargetFigures& out) {
  const TileMesh& tiles = geometry.tiles;
  const Truncation& truncation = geometry.truncation;
  out.interface_share.resize(static_cast<Eigen::Index>(geometry.patches.size()));
  for (std::size_t k = 0; k < geometry.patches.size(); ++k) {
    const ContactPatch& patch = geometry.patches[k];
    const double back = (patch.point[3] - patch.point[2]).norm();
    out.interface_share[static_cast<Eigen::Index>(k)] =
        patch.point_count < 4 ? 0.0 : back / (patch.point[1] - patch.point[0]).norm();
  }
  std::set<std::array<int, 2>> trimmed;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (const TruncationPlane& plane : truncation.of_tile[i]) {
      if (plane.type == 4) trimmed.insert({std::min(i, plane.other), std::max(i, plane.other)});
    }
  }
  out.trimmed.assign(trimmed.begin(), trimmed.end());
  out.overlapping = truncation.unresolved;
  out.pin_area = geometry.pin_bounds.area;
  out.membrane_clearance = membrane_clearance(tiles, geometry.pin_bounds.lower, p.H_pin);
}

// Conformal scale of each tile of a piece, in the order of its faces.
Eigen::VectorXd scale_of(const MeshPiece& piece) {
  return conformal_scale(piece.mesh, conformal_map(piece.mesh));
}

// Conformal scale, piece by piece as initial_layout scales its start: so that the median tile fits.
Eigen::VectorXd start_stretch(const TileMesh& tiles, const Eigen::VectorXd& least) {
  Eigen::VectorXd out =
      Eigen::VectorXd::Constant(tiles.tile_count(), std::numeric_limits<double>::quiet_NaN());
  for (const MeshPiece& piece : cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    Eigen::VectorXd scale;
    try {
      scale = scale_of(piece);
    } catch (const TopologyError&) {  // closed, with handles: cuts come first
      continue;
    } catch (const SolverFailure&) {
      continue;
    }
    std::vector<double> needed;
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
      if (scale[k] > 0) needed.push_back(least[piece.faces[k]] / scale[k]);
    }
    if (needed.empty()) continue;
    const auto median = needed.begin() + static_cast<long>(needed.size() / 2);
    std::nth_element(needed.begin(), median, needed.end());
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
      out[piece.faces[k]] = std::max(0.0, *median * scale[k]);
    }
  }
  return out;
}

// Inset, equal at all edges, that leaves a side A_pin_min: the farther pins are apart, the longer
// is the membrane that can follow a gap.
double widest_inset(const TileMesh& tiles, const Parameters& p, int tile, Side side) {
  const double perimeter = tiles.length.row(tile).sum();
  const double shift =
      side == Side::back ? tiles.back_shift.row(tile).dot(tiles.length.row(tile)) : 0.0;
  const double left = 1 - std::sqrt(std::min(1.0, p.A_pin_min / tiles.area(tile)));
  const double widest = (2 * tiles.area(tile) * left - shift) / perimeter;
  return std::clamp(widest, std::min(p.p_min, p.p_max), p.p_max);
}

// Mean gap of a contact at which its membrane is slack on one side, mm.
double widest_gap(const TileMesh& tiles, const Parameters& p, const Contact& contact) {
  double least = infinite;
  const int i = contact.tile[0], j = contact.tile[1];
  for (Side side : {Side::front, Side::back}) {
    const double dihedral = tiles.dihedral(i, contact.side[0]);
    const double half = side == Side::front ? 0.5 * dihedral : -0.5 * dihedral;
    const double q1 = widest_inset(tiles, p, i, side), q2 = widest_inset(tiles, p, j, side);
    const double shift = side == Side::back ? 2 * tiles.back_shift(i, contact.side[0]) : 0.0;
    const double length = spring_length(q1, q2, half, p.H_pin).length;
    least = std::min(least, p.tau * length - q1 - q2 - shift);
  }
  return least;
}

}  // namespace

TargetFigures target_figures(const TriangleMesh& mesh, const Edges& cuts, const Parameters& p) {
  TileMesh tiles = make_tile_mesh(mesh, cuts, p.H_body);
  const int count = tiles.tile_count();
  const auto contact_count = static_cast<Eigen::Index>(tiles.contacts.size());
  TargetFigures out;
  out.contacts = contact_tiles(tiles);
  out.dihedral.resize(contact_count);
  out.dihedral_margin.resize(contact_count);
  out.back_scale.resize(count);
  out.least_stretch.resize(count);
  out.most_stretch.setConstant(count, infinite);
  for (int i = 0; i < count; ++i) {
    out.back_scale[i] = back_scale(tiles, i);
    out.least_stretch[i] = inradius_with_gap(tiles, i, p.d_gap_min) / tile_inradius(tiles, i);
  }
  for (Eigen::Index k = 0; k < contact_count; ++k) {
    const Contact& contact = tiles.contacts[static_cast<std::size_t>(k)];
    const double gap = widest_gap(tiles, p, contact);
    out.dihedral[k] = degrees * tiles.dihedral(contact.tile[0], contact.side[0]);
    out.dihedral_margin[k] = 180;
    for (int s = 0; s < 2; ++s) {
      const int i = contact.tile[s];
      const double margin = dihedral_margin(tiles, i, contact.side[s], out.back_scale[i]);
      out.dihedral_margin[k] = std::min(out.dihedral_margin[k], degrees * margin);
      const double most = 1 + gap / (2 * tile_inradius(tiles, i));
      out.most_stretch[i] = std::min(out.most_stretch[i], std::max(0.0, most));
    }
  }
  out.stretch = start_stretch(tiles, out.least_stretch);
  out.shaped = tiles_without_back(tiles).empty();
  if (out.shaped) {
    add_shapes(make_geometry(std::move(tiles), p), p, out);
  } else {
    out.pin_area = compute_pin_bounds(tiles, truncate_at_vertices(tiles), p).area;
  }
  return out;
}

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
  std::vector<int> closed, odd;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if ((beside_holes.row(i) - bounds.lower.row(i)).maxCoeff() > tolerance::constraint) {
      closed.push_back(i);
    }
    const double mean = tiles.length.row(i).mean();
    if (mean < 0.5 * parameters.L || mean > 2 * parameters.L) odd.push_back(i);
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
  const Parameters& p = design.parameters;
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, p);
  const TileMesh& tiles = geometry.tiles;
  DesignFigures figures;
  figures.contacts = contact_tiles(tiles);
  figures.gap = contact_gaps(tiles, fit_poses(tiles, design.T));
  figures.pin_area.resize(tiles.tile_count(), 2);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (Side side : {Side::front, Side::back}) {
      figures.pin_area(i, static_cast<int>(side)) =
          pin_area(tiles, i, side, design.q.row(i).data());
    }
  }
  for (std::size_t k = 0; k < geometry.patches.size(); ++k) {
    if (geometry.patches[k].point_count == 2) figures.hinges.push_back(static_cast<int>(k));
    figures.three_point_contacts += geometry.patches[k].point_count == 3;
  }
  figures.truncation_types = geometry.truncation.pairs_of_type;
  figures.unresolved = geometry.truncation.unresolved;
  figures.shortened = geometry.truncation.shortened;
  figures.actuated_area = tiles.area.sum();
  figures.flat_area = flat_area(geometry, design.T);
  figures.constraints = check_constraints(geometry, design.T, design.q, p);
  const double standing = p.bumps == "none" ? 0.0 : p.bump_height - 2 * wall_recess(p);
  figures.flat_clearance = p.d_gap_min - std::max(0.0, standing);
  figures.reasons = broken_constraints(figures, p.A_pin_floor);
  return figures;
}

Eigen::VectorXd relative_scale(const TileMesh& tiles) {
  Eigen::VectorXd out(tiles.tile_count());
  for (const MeshPiece& piece : cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    const Eigen::VectorXd scale = scale_of(piece);
    double sum = 0, area = 0;
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
      const double a = tiles.area[piece.faces[k]];
      if (scale[k] > 0) sum += a * std::log(scale[k]), area += a;
    }
    const double mean = area > 0 ? std::exp(sum / area) : 1.0;
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
      out[piece.faces[k]] = std::max(least_scale, scale[k] / mean);
    }
  }
  return out;
}

double scale_spread(const Eigen::VectorXd& scale) { return scale.maxCoeff() / scale.minCoeff(); }

LayoutFigures layout_figures(const DesignGeometry& geometry, const Parameters& parameters,
                             const FlatPoses& poses, const Array6& q) {
  LayoutFigures out;
  const TileMesh& tiles = geometry.tiles;
  out.scale_spread = scale_spread(relative_scale(tiles));
  out.area_ratio = flat_area(geometry, flat_corners(tiles, poses)) / tiles.area.sum();
  if (tiles.contacts.empty()) return out;
  const LayoutModel model = make_layout_model(geometry, parameters);
  const LayoutState state = state_of(model, poses, q);
  for (const auto& term : make_energies(model)) out.energy += 2 * term->value(state);
  out.energy /= static_cast<double>(tiles.contacts.size());
  const auto springs = make_spring_energy(model);
  LayoutTerm::Value spring;
  for (int k = 0; k < springs->element_count(); ++k) {
    springs->at(k, state, false, spring);
    const double ratio = spring.value.head(springs->dimension()).norm();
    out.spring_mean += ratio / springs->element_count();
    out.slack_springs += ratio > 1;
  }
  return out;
}

}  // namespace curveups
