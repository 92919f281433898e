// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/tile_margins.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "curveups/design/design.hpp"
#include "curveups/design/membrane_clearance.hpp"

namespace curveups {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

double dihedral_margin(const TileMesh& tiles, int i, int t, double scale) {
  const double spare = 2 * tiles.area(i) * scale / (tiles.length(i, t) * tiles.H_body);
  const double half = 0.5 * tiles.dihedral(i, t);
  return 2 * (std::atan(std::tan(half) + spare) - half);
}

void add_membrane_clearance(const TileMesh& tiles, const Array6& lower, double H_pin,
                            TileMargins& out) {
  out.membrane_clearance.setConstant(tiles.tile_count(), 2, H_pin);
  auto lessen = [&](int tile, Side side, double clearance) {
    double& value = out.membrane_clearance(tile, static_cast<int>(side));
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
}

void add_shapes(const DesignGeometry& geometry, const Parameters& parameters, TileMargins& out) {
  const TileMesh& tiles = geometry.tiles;
  const Truncation& truncation = geometry.truncation;
  const PinBounds& bounds = geometry.pin_bounds;
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
  out.pin_area.resize(tiles.tile_count(), 2);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (Side side : {Side::front, Side::back}) {
      out.pin_area(i, static_cast<int>(side)) =
          pin_region(tiles, truncation, parameters, i, side, parameters.p_min).area;
    }
  }
  for (const SmallPin& pin : bounds.small) {
    out.pin_area(pin.tile, static_cast<int>(pin.side)) = pin.area;
  }
  add_membrane_clearance(tiles, bounds.lower, parameters.H_pin, out);
}

}  // namespace

TileMargins tile_margins(const TriangleMesh& mesh, const Edges& cuts,
                         const Parameters& parameters) {
  TileMesh tiles = make_tile_mesh(mesh, cuts, parameters.H_body);
  const auto contact_count = static_cast<Eigen::Index>(tiles.contacts.size());
  TileMargins out;
  out.back_scale.resize(tiles.tile_count());
  for (int i = 0; i < tiles.tile_count(); ++i) out.back_scale[i] = back_scale(tiles, i);
  out.contacts = contact_tiles(tiles);
  out.dihedral.resize(contact_count);
  out.dihedral_margin.resize(contact_count);
  for (Eigen::Index k = 0; k < contact_count; ++k) {
    const Contact& contact = tiles.contacts[static_cast<std::size_t>(k)];
    out.dihedral[k] = degrees * tiles.dihedral(contact.tile[0], contact.side[0]);
    double clearance = 180;
    for (int s = 0; s < 2; ++s) {
      const int i = contact.tile[s];
      clearance = std::min(clearance,
                           degrees * dihedral_margin(tiles, i, contact.side[s], out.back_scale[i]));
    }
    out.dihedral_margin[k] = clearance;
  }
  out.shaped = tiles_without_back(tiles).empty();
  if (out.shaped) add_shapes(make_geometry(std::move(tiles), parameters), parameters, out);
  return out;
}

}  // namespace curveups
