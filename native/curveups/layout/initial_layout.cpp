// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/initial_layout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {
namespace {

constexpr int spreading_sweeps =
    50;  // sweeps of Gauss and Seidel, for the few vertices of new tiles
constexpr double inset_room = 0.02;  // of an earlier inset from its bounds, over their distance

// Map of a piece by the mean of its tiles' earlier corners; nothing where that is of no use.
std::optional<Points2> earlier_map(const MeshPiece& piece, const FlatCorners& T) {
  const Triangles& F = piece.mesh.F;
  Points2 map = Points2::Zero(piece.mesh.V.rows(), 2);
  Eigen::VectorXi count = Eigen::VectorXi::Zero(map.rows());
  Eigen::Index known = 0;
  for (Eigen::Index k = 0; k < F.rows(); ++k) {
    const auto corners = T.row(piece.faces[k]);
    if (!corners.allFinite()) continue;
    ++known;
    for (int t = 0; t < 3; ++t) {
      map.row(F(k, t)) += corners.segment<2>(2 * t);
      ++count[F(k, t)];
    }
  }
  if (2 * known < F.rows()) return std::nullopt;
  std::vector<std::vector<int>> around(map.rows());  // neighbours of vertices without a place
  Eigen::RowVector2d middle = map.colwise().sum() / count.sum();
  for (Eigen::Index v = 0; v < map.rows(); ++v) {
    if (count[v] > 0) {
      map.row(v) /= count[v];
    } else {
      map.row(v) = middle;
    }
  }
  for (Eigen::Index k = 0; k < F.rows(); ++k) {
    for (int t = 0; t < 3; ++t) {
      if (count[F(k, t)] > 0) continue;
      around[F(k, t)].push_back(F(k, next3(t)));
      around[F(k, t)].push_back(F(k, prev3(t)));
    }
  }
  for (int sweep = 0; sweep < spreading_sweeps; ++sweep) {
    for (std::size_t v = 0; v < around.size(); ++v) {
      if (around[v].empty()) continue;
      Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
      for (int w : around[v]) sum += map.row(w);
      map.row(static_cast<Eigen::Index>(v)) = sum / static_cast<double>(around[v].size());
    }
  }
  for (Eigen::Index k = 0; k < F.rows(); ++k) {
    const Vec2 a = map.row(F(k, 0)), b = map.row(F(k, 1)), c = map.row(F(k, 2));
    if (wedge(b - a, c - a) <= 0) return std::nullopt;
  }
  return map;
}

double inradius(double area, double perimeter) { return 2 * area / perimeter; }

}  // namespace

double tile_inradius(const TileMesh& tiles, int tile) {
  return inradius(tiles.area(tile), tiles.length.row(tile).sum());
}

double inradius_with_gap(const TileMesh& tiles, int tile, double d_gap_min) {
  const double outside = std::max(0.0, -tiles.back_shift.row(tile).mean());
  return tile_inradius(tiles, tile) + outside + 0.5 * d_gap_min;
}

LayoutState initial_layout(const LayoutModel& model, const EarlierLayout* earlier) {
  const TileMesh& tiles = model.geometry->tiles;
  LayoutState state(model.tile_count(), unknowns_per_tile);
  double left = 0;
  for (const MeshPiece& part : cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    const std::vector<int>& piece = part.faces;
    std::optional<Points2> known;
    if (earlier != nullptr) known = earlier_map(part, earlier->T);
    Points2 map = known ? *known : conformal_map(part.mesh);
    const auto triangle = [&map, &F = part.mesh.F](std::size_t k) {
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
  if (earlier == nullptr) return state;
  const Array6 room = inset_room * (bounds.upper - bounds.lower).cwiseMax(0);
  for (int i = 0; i < model.tile_count(); ++i) {
    if (!earlier->q.row(i).allFinite()) continue;
    state.row(i).tail<6>() = earlier->q.row(i)
                                 .cwiseMax(bounds.lower.row(i) + room.row(i))
                                 .cwiseMin(bounds.upper.row(i) - room.row(i));
  }
  return state;
}

}  // namespace curveups
