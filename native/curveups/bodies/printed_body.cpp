// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/printed_body.hpp"

#include <cmath>

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

// The part of `way` that a plane may turn in while it keeps the corners on it: square to what joins
// them. Zero where they leave it no freedom.
Vec3 free_part(Vec3 way, const std::vector<Vec3>& on) {
  if (on.size() > 2) return Vec3::Zero();
  if (on.size() == 2) {
    const Vec3 axis = (on[1] - on[0]).normalized();
    way -= way.dot(axis) * axis;
  }
  return way;
}

// The plane, moved inwards where it passes a corner of the body by less than least_cut.
Plane clear_of_corners(const ConvexBody& body, Plane plane) {
  // Each move puts a corner onto the plane, or away from it for good but for later moves.
  for (int round = 0; round < 6; ++round) {
    std::vector<Vec3> on;
    const Vec3* near = nullptr;
    double depth = 0;
    for (const Vec3& p : body.points) {
      const double d = plane.distance(p);
      if (std::abs(d) <= tolerance::snap) {
        on.push_back(p);
      } else if (std::abs(d) < least_cut && (!near || d < depth)) {
        near = &p;
        depth = d;
      }
    }
    if (!near) return plane;
    // One that is kept becomes a corner of the cut, one that is not is cut off deeper.
    const double by = depth < 0 ? -depth : least_cut - depth;
    if (on.empty()) {
      plane.offset -= by;
      continue;
    }
    const Vec3 way = free_part(*near - on[0], on);
    if (way.norm() < 100 * least_cut) return plane;  // it would turn by more than it is off
    const Vec3 normal = plane.normal + by / way.squaredNorm() * way;
    plane.normal = normal.normalized();
    plane.offset = plane.normal.dot(on[0]);
  }
  return plane;
}

}  // namespace

ConvexBody printed_body(const TileMesh& tiles, const Truncation& truncation, int tile,
                        const std::array<double, 3>& recess) {
  Truncation none;
  none.of_tile.resize(tiles.tile_count());
  ConvexBody body = tile_body(tiles, none, tile, recess);
  int tag = body_tag::cut;
  for (const TruncationPlane& t : truncation.of_tile[tile]) {
    clip(body, clear_of_corners(body, t.plane), tag++);
    if (body.faces.empty()) break;
  }
  return body;
}

}  // namespace curveups
