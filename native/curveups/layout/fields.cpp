// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/constraints.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/spring_length.hpp"

namespace curveups {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

// Conformal scale, piece by piece as initial_layout scales its start: so that the median tile fits.
Eigen::VectorXd start_stretch(const TileMesh& tiles, const Eigen::VectorXd& least) {
  Eigen::VectorXd out =
      Eigen::VectorXd::Constant(tiles.tile_count(), std::numeric_limits<double>::quiet_NaN());
  for (const MeshPiece& piece : cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    Eigen::VectorXd scale;
    try {
      scale = conformal_scale(piece.mesh, conformal_map(piece.mesh));
    } catch (const TopologyError&) {  // closed, with handles: cuts come first
      continue;
    } catch (const SolverFailure&) {
      continue;
    }
    std::vector<double> needed;
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      const double s = scale[static_cast<Eigen::Index>(k)];
      if (s > 0) needed.push_back(least[piece.faces[k]] / s);
    }
    if (needed.empty()) continue;
    const auto median = needed.begin() + static_cast<long>(needed.size() / 2);
    std::nth_element(needed.begin(), median, needed.end());
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      out[piece.faces[k]] = std::max(0.0, *median * scale[static_cast<Eigen::Index>(k)]);
    }
  }
  return out;
}

// The inset, the same at all edges, that leaves a side A_pin_min: the farther pins are from one
// another the longer is the membrane that can follow a gap.
double widest_inset(const TileMesh& tiles, const Parameters& p, int tile, Side side) {
  const double perimeter = tiles.length.row(tile).sum();
  const double shift =
      side == Side::back ? tiles.back_shift.row(tile).dot(tiles.length.row(tile)) : 0.0;
  const double left = 1 - std::sqrt(std::min(1.0, p.A_pin_min / tiles.area(tile)));
  const double widest = (2 * tiles.area(tile) * left - shift) / perimeter;
  return std::clamp(widest, std::min(p.p_min, p.p_max), p.p_max);
}

// The mean gap of a contact at which its membrane is slack on one side, mm.
double widest_gap(const TileMesh& tiles, const Parameters& p, const Contact& contact) {
  double least = std::numeric_limits<double>::infinity();
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

TargetFields target_fields(const TriangleMesh& mesh, const Edges& cuts, const Parameters& p) {
  const TileMesh tiles = make_tile_mesh(mesh, cuts, p.H_body);
  const int count = tiles.tile_count();
  const auto contact_count = static_cast<Eigen::Index>(tiles.contacts.size());
  TargetFields out;
  out.contacts = contact_tiles(tiles);
  out.dihedral.resize(contact_count);
  out.least_stretch.resize(count);
  out.most_stretch.setConstant(count, std::numeric_limits<double>::infinity());
  for (int i = 0; i < count; ++i) {
    out.least_stretch[i] = inradius_with_gap(tiles, i, p.d_gap_min) / tile_inradius(tiles, i);
  }
  for (Eigen::Index k = 0; k < contact_count; ++k) {
    const Contact& contact = tiles.contacts[static_cast<std::size_t>(k)];
    out.dihedral[k] = degrees * tiles.dihedral(contact.tile[0], contact.side[0]);
    const double gap = widest_gap(tiles, p, contact);
    for (int i : contact.tile) {
      const double most = 1 + gap / (2 * tile_inradius(tiles, i));
      out.most_stretch[i] = std::min(out.most_stretch[i], std::max(0.0, most));
    }
  }
  const Truncation truncation = truncate_at_vertices(tiles);
  out.pin_area_margin.resize(count, 2);
  parallel_ranges(count, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      for (Side side : {Side::front, Side::back}) {
        out.pin_area_margin(i, static_cast<int>(side)) =
            pin_region(tiles, truncation, p, i, side, p.p_min).area - p.A_pin_min;
      }
    }
  });
  out.stretch = start_stretch(tiles, out.least_stretch);
  return out;
}

DesignFields design_fields(const Design& design) {
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const TileMesh& tiles = geometry.tiles;
  const FlatPoses poses = fit_poses(tiles, design.T);
  DesignFields out;
  out.contacts = contact_tiles(tiles);
  out.gap = contact_gaps(tiles, poses);
  out.pin_area.resize(tiles.tile_count(), 2);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (Side side : {Side::front, Side::back}) {
      out.pin_area(i, static_cast<int>(side)) = pin_area(tiles, i, side, design.q.row(i).data());
    }
  }
  return out;
}

}  // namespace curveups
