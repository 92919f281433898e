// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/vertex_rows.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"
#include "curveups/core/sort_unique.hpp"

namespace curveups {

std::vector<VertexEntry> rows_by_vertex(const LayoutModel& model, const LayoutState& state,
                                        const std::vector<ConstraintRow>& rows,
                                        const MovingVertices& vertices) {
  std::vector<std::vector<int>> rows_of(model.tile_count());
  {
    const LayoutTerms functions = make_constraints(model);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (int tile : functions[rows[r].function]->blocks(rows[r].block)) {
        if (tile >= 0) rows_of[tile].push_back(static_cast<int>(r));
      }
    }
  }
  std::vector<std::vector<VertexEntry>> entries(vertices.count());
  parallel_ranges(vertices.count(), [&](int begin, int end) {
    LayoutModel varied = model;
    const LayoutTerms functions = make_constraints(varied);
    LayoutTerm::Value value;
    for (int v = begin; v < end; ++v) {
      const VertexPatch& patch = vertices.patches[v];
      std::vector<int> touched;
      for (int k : patch.changed) {
        const std::vector<int>& own = rows_of[patch.tiles[k]];
        touched.insert(touched.end(), own.begin(), own.end());
      }
      sort_unique(touched);
      if (touched.empty()) continue;
      const Eigen::MatrixXd by_vertex =
          derivatives_by_vertex(patch, [&](const LocalGeometry& local) {
            for (int k : patch.changed) {
              varied.tiles[patch.tiles[k]] = make_layout_tile(local.tiles, k);
            }
            Eigen::VectorXd out(static_cast<Eigen::Index>(touched.size()));
            for (std::size_t r = 0; r < touched.size(); ++r) {
              const ConstraintRow& row = rows[touched[r]];
              functions[row.function]->at(row.block, state, false, value);
              out(static_cast<Eigen::Index>(r)) = value.value(0);
            }
            return out;
          });
      for (int k : patch.changed) varied.tiles[patch.tiles[k]] = model.tiles[patch.tiles[k]];
      for (std::size_t r = 0; r < touched.size(); ++r) {
        const Vec3 derivative = by_vertex.row(static_cast<Eigen::Index>(r));
        if (derivative != Vec3::Zero()) entries[v].push_back({touched[r], v, derivative});
      }
    }
  });
  std::vector<VertexEntry> out;
  for (const auto& list : entries) out.insert(out.end(), list.begin(), list.end());
  return out;
}

Eigen::Matrix<double, 2, 3> centroid_by_corner(const TileMesh& tiles, int tile, int t) {
  // The frame's origin is corner 0, its x axis runs to corner 1.
  const RigidMotion& frame = tiles.frame[tile];
  const std::array<Vec2, 3>& front = tiles.front[tile];
  const Vec2 centroid = (front[0] + front[1] + front[2]) / 3;
  const double shift = 1.0 / 3 - (t == 0 ? 1.0 : 0.0), turn = t == 1 ? 1.0 : t == 0 ? -1.0 : 0.0;
  const Eigen::RowVector3d turning = (turn / tiles.length(tile, 0)) * frame.R.col(1).transpose();
  Eigen::Matrix<double, 2, 3> out;
  out.row(0) = shift * frame.R.col(0).transpose() + centroid.y() * turning;
  out.row(1) = shift * frame.R.col(1).transpose() - centroid.x() * turning;
  return out;
}

}  // namespace curveups
