// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/tile_shapes.hpp"

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Write both triangles' corners at their heights, moved by `to_place` from the tile's frame.
template <class Place>
void put(const std::array<Vec2, 3>& first, double first_z, const std::array<Vec2, 3>& second,
         double second_z, const Place& to_place, double* out) {
  for (int t = 0; t < 3; ++t) {
    Eigen::Map<Vec3>(out + 3 * t) = to_place(Vec3(first[t].x(), first[t].y(), first_z));
    Eigen::Map<Vec3>(out + 9 + 3 * t) = to_place(Vec3(second[t].x(), second[t].y(), second_z));
  }
}

}  // namespace

TileShapes tile_shapes(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters,
                       const FlatCorners& T, const Array6& q) {
  const TileMesh tiles = make_tile_mesh(mesh, cuts, parameters.H_body);
  const int count = tiles.tile_count();
  if (T.rows()) require_row_per_tile(T, count, "T");
  if (q.rows()) require_row_per_tile(q, count, "q");
  require_back_faces(tiles);
  const FlatPoses poses = T.rows() ? fit_poses(tiles, T) : FlatPoses(0, 3);
  TileShapes out;
  out.actuated.resize(count, Eigen::NoChange);
  out.flat.resize(T.rows(), Eigen::NoChange);
  out.actuated_pins.resize(q.rows(), Eigen::NoChange);
  out.flat_pins.resize(T.rows() ? q.rows() : 0, Eigen::NoChange);
  parallel_for(count, [&](int i) {
    const auto actuated = [&](const Vec3& p) { return tiles.frame[i](p); };
    const PlaneRotation turn(T.rows() ? poses(i, 2) : 0.0);
    const auto flat = [&](const Vec3& p) {
      const Vec2 at = Vec2(poses(i, 0), poses(i, 1)) + turn * p.head<2>();
      return Vec3(at.x(), at.y(), p.z());
    };
    put(tiles.front[i], 0, tiles.back[i], -tiles.H_body, actuated, out.actuated.row(i).data());
    if (T.rows()) {
      put(tiles.front[i], 0, tiles.back[i], -tiles.H_body, flat, out.flat.row(i).data());
    }
    for (Side side : {Side::front, Side::back}) {
      if (!q.rows()) break;
      const int s = static_cast<int>(side);
      const std::array<Vec2, 3> pin = pin_corners(tiles, i, side, q.row(i).data());
      const double foot = side == Side::front ? 0 : -tiles.H_body;
      const double top = side == Side::front ? parameters.H_pin : foot - parameters.H_pin;
      put(pin, foot, pin, top, actuated, out.actuated_pins.row(i).data() + 18 * s);
      if (T.rows()) put(pin, foot, pin, top, flat, out.flat_pins.row(i).data() + 18 * s);
    }
  });
  out.contacts = contact_tiles(tiles);
  out.contact_sides.resize(out.contacts.rows(), 2);
  for (Eigen::Index k = 0; k < out.contacts.rows(); ++k) {
    const std::array<int, 2>& side = tiles.contacts[static_cast<std::size_t>(k)].side;
    out.contact_sides.row(k) << side[0], side[1];
  }
  return out;
}

}  // namespace curveups
