// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/facing_pins.hpp"

#include <algorithm>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/design/remote_overlaps.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

// Body, front pin, back pin, in world coordinates; a pin without room has no faces.
using Parts = std::array<ConvexBody, 3>;

// Clips a pin as keep-outs bound its insets: the prism stays behind the plane with foot and top.
// Planes along the face bound no inset (add_keepouts).
void keep_behind(ConvexBody& pin, const Plane& plane, double z_low, double z_high) {
  const double level = plane.normal.head<2>().norm();
  if (level < 1e-9 || pin.faces.empty()) return;
  const double height = std::max(plane.normal.z() * z_low, plane.normal.z() * z_high);
  const Vec3 normal(plane.normal.x() / level, plane.normal.y() / level, 0);
  clip(pin, {normal, (plane.offset - height) / level}, body_tag::cut);
}

Parts make_parts(const DesignGeometry& geometry, int tile, double H_pin) {
  const TileMesh& tiles = geometry.tiles;
  const double* q = geometry.pin_bounds.lower.row(tile).data();
  const double back = -tiles.H_body;
  Parts parts{tile_body(tiles, geometry.truncation, tile),
              make_prism(pin_corners(tiles, tile, Side::front, q), 0, H_pin),
              make_prism(pin_corners(tiles, tile, Side::back, q), back - H_pin, back)};
  for (Side side : {Side::front, Side::back}) {
    ConvexBody& pin = parts[side == Side::front ? 1 : 2];
    if (!(pin_area(tiles, tile, side, q) > 0)) pin = {};  // turned over: there is none
    const auto& planes =
        side == Side::front ? geometry.truncation.front_pins : geometry.truncation.of_tile;
    const double z = side == Side::front ? 0 : back - H_pin;
    for (const TruncationPlane& plane : planes[tile]) {
      keep_behind(pin, plane.plane, z, z + H_pin);
    }
  }
  const RigidMotion& motion = tiles.frame[tile];
  for (ConvexBody& part : parts) part = moved(part, motion);
  return parts;
}

bool pins_meet(const Parts& a, const Parts& b) {
  for (int p = 0; p < 3; ++p) {
    for (int q = 0; q < 3; ++q) {
      if (p + q == 0 || a[p].faces.empty() || b[q].faces.empty()) continue;
      if (common_volume(a[p], b[q]) > tolerance::overlap_volume) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::array<int, 2>> facing_pins(const DesignGeometry& geometry, double H_pin) {
  const int count = geometry.tiles.tile_count();
  std::vector<Parts> parts(count);
  std::vector<Eigen::AlignedBox3d> boxes(count);
  parallel_for(count, [&](int i) {
    parts[i] = make_parts(geometry, i, H_pin);
    for (const ConvexBody& part : parts[i]) boxes[i].extend(bounding_box(part));
  });
  const std::vector<std::array<int, 2>> near = overlapping_boxes(boxes);
  std::vector<char> meet(near.size(), 0);
  parallel_for(static_cast<int>(near.size()), [&](int k) {
    const auto [i, j] = near[k];
    meet[k] = !share_vertex(geometry.tiles.mesh.F, i, j) && pins_meet(parts[i], parts[j]);
  });
  std::vector<std::array<int, 2>> out;
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (meet[k]) out.push_back(near[k]);
  }
  return out;
}

}  // namespace curveups
