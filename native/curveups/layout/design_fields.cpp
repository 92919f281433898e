// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/design_fields.hpp"

#include "curveups/design/constraints.hpp"
#include "curveups/layout/layout_figures.hpp"
#include "curveups/layout/spring_forces.hpp"

namespace curveups {

DesignFields design_fields(const Design& design) {
  const auto count = static_cast<int>(design.mesh.F.rows());
  require_row_per_tile(design.T, count, "T");
  require_row_per_tile(design.q, count, "q");
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const TileMesh& tiles = geometry.tiles;
  const FlatPoses poses = fit_poses(tiles, design.T);
  DesignFields out;
  out.contacts.resize(static_cast<Eigen::Index>(tiles.contacts.size()), 2);
  for (Eigen::Index k = 0; k < out.contacts.rows(); ++k) {
    const Contact& contact = tiles.contacts[static_cast<std::size_t>(k)];
    out.contacts.row(k) << contact.tile[0], contact.tile[1];
  }
  out.gap = contact_gaps(tiles, poses);
  out.pin_area.resize(tiles.tile_count(), 2);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (Side side : {Side::front, Side::back}) {
      out.pin_area(i, static_cast<int>(side)) = pin_area(tiles, i, side, design.q.row(i).data());
    }
  }
  const Eigen::VectorXd ratios = spring_ratios(geometry, design.parameters, poses, design.q);
  out.membrane_slack = Eigen::Map<const PerSide>(ratios.data(), out.contacts.rows(), 2);
  out.spring_force = spring_forces(geometry, design.parameters, poses, design.q);
  out.weak = weak_by_springs(out.spring_force, design.parameters.f_min_ratio);
  return out;
}

}  // namespace curveups
