// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/force_rows.hpp"

namespace curveups {

ForceRow make_force_row(const Iterate& place, double value, double unit,
                        const ForceGradient& gradient, const MovingVertices* moving) {
  const TileMesh& tiles = place.geometry().tiles;
  ForceRow row{value, LayoutState(place.state.rows(), unknowns_per_tile), gradient.by_vertex};
  row.gradient << gradient.by_pose, gradient.by_inset;
  for (int i = 0; i < place.state.rows(); ++i) {
    // Poses turn about front corner 0, the layout's unknowns about the centroid.
    const Vec2 arm = PlaneRotation(place.state(i, 2)) * place.model().tiles[i].corner[0][0];
    row.gradient(i, 2) += left_of(arm).dot(Vec2(row.gradient(i, 0), row.gradient(i, 1)));
  }
  for (int v = 0; moving && v < moving->count(); ++v) {
    // And corner 0 moves about the centroid, which is held, as the vertex changes the tile.
    const VertexPatch& patch = moving->patches[v];
    for (int k : patch.changed) {
      const int tile = patch.tiles[k];
      for (int t = 0; t < 3; ++t) {
        if (tiles.mesh.F(tile, t) != moving->vertex[v]) continue;
        const PlaneRotation back(-place.state(tile, 2));
        const Vec2 pull = back * Vec2(gradient.by_pose(tile, 0), gradient.by_pose(tile, 1));
        row.by_vertex.row(v) -= pull.transpose() * centroid_by_corner(tiles, tile, t);
      }
    }
  }
  row.gradient *= unit;
  row.by_vertex *= unit;
  return row;
}

MovingVertices vertices_to_move(const Iterate& place, const TrackedForces& tracked,
                                const Judgement& now, const VertexPlaces& target) {
  const TileMesh& tiles = place.geometry().tiles;
  const std::vector<ContactPoint>& points = tracked.points();
  std::vector<char> near(tiles.tile_count(), 0), chosen(target.place.rows(), 0);
  auto mark = [&](const std::array<int, 2>& pair) {
    for (int tile : pair) {
      near[tile] = 1;
      for (int t = 0; t < 3; ++t) {
        if (const int n = tiles.topology.neighbour(tile, t); n >= 0) near[n] = 1;
      }
    }
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (now.normal(static_cast<Eigen::Index>(p)) < force_goal * now.f_min) {
      mark(points[p].tile);
    }
  }
  for (const std::array<int, 2>& pair : tracked.critical_pairs()) mark(pair);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3 && near[i]; ++t) chosen[tiles.mesh.F(i, t)] = 1;
  }
  const VertexPatches patches(place.geometry());
  MovingVertices out;
  for (int v = 0; v < target.place.rows(); ++v) {
    if (!chosen[v]) continue;
    out.vertex.push_back(v);
    out.patches.push_back(patches.around(v));
  }
  out.moved.resize(out.count(), 3);
  out.weight.resize(out.count());
  for (int k = 0; k < out.count(); ++k) {
    out.moved.row(k) = place.vertices().row(out.vertex[k]) - target.place.row(out.vertex[k]);
    out.weight(k) = target.area(out.vertex[k]);
  }
  return out;
}

std::vector<ForceRow> force_rows(const Iterate& place, const TrackedForces& tracked,
                                 const Judgement& now, const MovingVertices* moving) {
  const std::vector<ContactPoint>& points = tracked.points();
  std::vector<int> chosen;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (now.normal(static_cast<Eigen::Index>(p)) < active_force * now.f_min) {
      chosen.push_back(static_cast<int>(p));
    }
  }
  Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()),
                                                    static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    functions(chosen[r], static_cast<Eigen::Index>(r)) = 1;
  }
  const std::vector<VertexPatch> none;
  const std::vector<VertexPatch>& patches = moving ? moving->patches : none;
  std::vector<ForceRow> rows;
  const std::vector<ForceGradient> gradients =
      force_gradients(tracked.forces(), functions, patches);
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    const double value = (now.normal(chosen[r]) - force_goal * now.f_min) / now.mean;
    rows.push_back(make_force_row(place, value, 1 / now.mean, gradients[r], moving));
  }
  if (tracked.floor_is_active() && tracked.floor().solve.status != SolveStatus::unfinished) {
    const double value = (now.floor - floor_goal) * now.f_min / now.mean;
    const ForceGradient gradient = floor_gradient(tracked.forces(), tracked.floor(), patches);
    rows.push_back(make_force_row(place, value, 1 / now.mean, gradient, moving));
  }
  return rows;
}

}  // namespace curveups
