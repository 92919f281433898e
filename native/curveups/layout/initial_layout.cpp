// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/initial_layout.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {
namespace {

double inradius(double area, double perimeter) { return 2 * area / perimeter; }

}  // namespace

double tile_inradius(const TileMesh& tiles, int tile) {
  return inradius(tiles.area(tile), tiles.length.row(tile).sum());
}

double inradius_with_gap(const TileMesh& tiles, int tile, double d_gap_min) {
  const double outside = std::max(0.0, -tiles.back_shift.row(tile).mean());
  return tile_inradius(tiles, tile) + outside + 0.5 * d_gap_min;
}

LayoutState initial_layout(const LayoutModel& model) {
  const TileMesh& tiles = model.geometry->tiles;
  LayoutState state(model.tile_count(), unknowns_per_tile);
  double left = 0;
  for (const auto& [mesh, piece, original] :
       cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    Points2 map = conformal_map(mesh);
    const auto triangle = [&map, &F = mesh.F](std::size_t k) {
      std::array<Vec2, 3> corner;
      for (int t = 0; t < 3; ++t) corner[t] = map.row(F(static_cast<Eigen::Index>(k), t));
      return corner;
    };
    std::vector<double> needed;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::array<Vec2, 3> corner = triangle(k);
      const double flat_inradius =
          inradius(0.5 * std::abs(wedge(corner[1] - corner[0], corner[2] - corner[0])),
                   (corner[1] - corner[0]).norm() + (corner[2] - corner[1]).norm() +
                       (corner[0] - corner[2]).norm());
      if (flat_inradius > 0) {
        needed.push_back(inradius_with_gap(tiles, piece[k], model.parameters.d_gap_min) /
                         flat_inradius);
      }
    }
    if (!needed.empty()) {
      std::nth_element(needed.begin(), needed.begin() + static_cast<long>(needed.size() / 2),
                       needed.end());
      map *= needed[needed.size() / 2];
    }
    const double shift = left - map.col(0).minCoeff() + 2 * model.L;
    map.col(0).array() += shift;
    left = map.col(0).maxCoeff() + 2 * model.L;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const int i = piece[k];
      const std::array<Vec2, 3> corner = triangle(k);
      const Vec2 middle = (corner[0] + corner[1] + corner[2]) / 3;
      double cosine = 0, sine = 0;
      for (int t = 0; t < 3; ++t) {
        cosine += model.tiles[i].corner[0][t].dot(corner[t] - middle);
        sine += wedge(model.tiles[i].corner[0][t], corner[t] - middle);
      }
      state.row(i).head<3>() << middle.x(), middle.y(), std::atan2(sine, cosine);
    }
  }
  const PinBounds& bounds = model.geometry->pin_bounds;
  state.rightCols<6>() = bounds.lower + 0.1 * (bounds.upper - bounds.lower);
  return state;
}

}  // namespace curveups
