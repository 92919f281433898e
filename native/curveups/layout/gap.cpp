// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 7, for counter-clockwise tiles: a corner of one tile keeps d_gap_min from an edge's line of
// another: gap - d_gap_min >= 0.
#include <algorithm>
#include <cmath>

#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

class GapConstraint : public LayoutTerm {
 public:
  explicit GapConstraint(const LayoutModel& model) : model_(model) {}

  std::string_view name() const override { return "gap"; }
  int element_count() const override { return static_cast<int>(model_.gaps.size()); }
  int dimension() const override { return 1; }
  int curvature_rows() const override { return 1; }
  Blocks blocks(int block) const override {
    return {model_.gaps[block].tile, model_.gaps[block].other};
  }

  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const CornerGap& gap = model_.gaps[block];
    const int s = static_cast<int>(gap.side);
    const LayoutTile& tile = model_.tiles[gap.tile];
    const PlacedTile placed(x[0]);
    const PlacedPoint on_line(placed, tile.corner[s][gap.edge]);
    const PlacedPoint corner(PlacedTile(x[1]), model_.tiles[gap.other].corner[s][gap.corner]);
    const Vec2 normal = placed.turn * tile.outward[gap.edge];
    const Vec2 d = corner.position - on_line.position;
    out.value(0) = normal.dot(d) - model_.parameters.d_gap_min;
    if (!derivatives) return;
    out.jacobian[0].row(0) << -normal.transpose(),
        left_of(normal).dot(d) - normal.dot(on_line.by_angle), 0, 0, 0, 0, 0, 0;
    out.jacobian[1].row(0) << normal.transpose(), normal.dot(corner.by_angle), 0, 0, 0, 0, 0, 0;
    // Turning the edge's tile moves its line on a circle about the tile's centre.
    out.jacobian[0].row(1).setZero();
    out.jacobian[1].row(1).setZero();
    out.jacobian[0](1, 2) = std::sqrt(std::max(0.0, normal.dot(corner.position - placed.middle)));
  }

 private:
  const LayoutModel& model_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_gap_constraint(const LayoutModel& model) {
  return std::make_unique<GapConstraint>(model);
}

}  // namespace curveups
