// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/layout_model.hpp"

namespace curveups {
namespace {

Vec2 centroid_of(const std::array<Vec2, 3>& triangle) {
  return (triangle[0] + triangle[1] + triangle[2]) / 3;
}

}  // namespace

LayoutTile make_layout_tile(const TileMesh& tiles, int i) {
  LayoutTile tile;
  const Vec2 middle = centroid_of(tiles.front[i]);
  tile.area = tiles.area(i);
  tile.shift = {0, tiles.back_shift.row(i).dot(tiles.length.row(i))};
  for (int t = 0; t < 3; ++t) {
    tile.corner[0][t] = tiles.front[i][t] - middle;
    tile.corner[1][t] = tiles.back[i][t] - middle;
    tile.outward[t] = -tiles.inward(i, t);
    tile.length[t] = tiles.length(i, t);
    const Vec2 along = left_of(tile.outward[t]);
    const Vec2 back = (tiles.front[i][prev3(t)] - tiles.front[i][t]).normalized();
    const double sine = wedge(along, back);
    tile.per_previous[t] = along / sine;
    tile.per_own[t] = back / sine;
  }
  return tile;
}

LayoutModel make_layout_model(const DesignGeometry& geometry, const Parameters& parameters) {
  const TileMesh& tiles = geometry.tiles;
  LayoutModel model;
  model.geometry = &geometry;
  model.parameters = parameters;
  model.L = parameters.L;
  for (int i = 0; i < tiles.tile_count(); ++i) model.tiles.push_back(make_layout_tile(tiles, i));
  for (const Contact& contact : tiles.contacts) {
    for (int d = 0; d < 2; ++d) {
      const int other_side = contact.side[1 - d];
      for (Side side : {Side::front, Side::back}) {
        for (int corner : {other_side, next3(other_side)}) {
          model.gaps.push_back(
              {contact.tile[d], contact.side[d], contact.tile[1 - d], corner, side});
        }
      }
    }
  }
  return model;
}

void add_separation(LayoutModel& model, const Separation& separation) {
  for (Side side : {Side::front, Side::back}) {
    for (int corner = 0; corner < 3; ++corner) {
      model.gaps.push_back({separation.tile, separation.side_edge, separation.other, corner, side});
    }
  }
}

FlatPoses poses_of(const LayoutModel& model, const LayoutState& state) {
  FlatPoses poses(state.rows(), 3);
  for (int i = 0; i < model.tile_count(); ++i) {
    // The pose is that of the frame's origin, front corner 0.
    const Vec2 origin =
        Vec2(state(i, 0), state(i, 1)) + PlaneRotation(state(i, 2)) * model.tiles[i].corner[0][0];
    poses.row(i) << origin.x(), origin.y(), state(i, 2);
  }
  return poses;
}

Array6 insets_of(const LayoutState& state) { return state.rightCols<6>(); }

LayoutState state_of(const LayoutModel& model, const FlatPoses& poses, const Array6& q) {
  LayoutState state(poses.rows(), unknowns_per_tile);
  for (int i = 0; i < model.tile_count(); ++i) {
    const Vec2 middle =
        Vec2(poses(i, 0), poses(i, 1)) - PlaneRotation(poses(i, 2)) * model.tiles[i].corner[0][0];
    state.row(i) << middle.x(), middle.y(), poses(i, 2), q.row(i);
  }
  return state;
}

}  // namespace curveups
