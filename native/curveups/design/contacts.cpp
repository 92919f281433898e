// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

// Largest slope of the planes at one end of a tile's edge: the wall of the neighbouring edge and
// every truncation plane pass through the end and leave u >= slope w, u along the edge and w down
// its wall. `at_start`: the end where the tile's edge begins.
double slope_at(const TileMesh& tiles, const Truncation& truncation, int tile, int edge,
                bool at_start) {
  const int corner = at_start ? edge : next3(edge);
  const int vertex = tiles.mesh.F(tile, corner);
  const Vec2 direction =
      (tiles.front[tile][next3(edge)] - tiles.front[tile][edge]) / tiles.length(tile, edge);
  const Vec3 along = (at_start ? 1.0 : -1.0) * Vec3(direction.x(), direction.y(), 0);
  const double half = 0.5 * tiles.dihedral(tile, edge);
  const Vec2 in = tiles.inward(tile, edge);
  const Vec3 down(in.x() * std::sin(half), in.y() * std::sin(half), -std::cos(half));
  double slope = -std::numeric_limits<double>::infinity();
  auto add = [&](const Vec3& normal) {
    const double rise = normal.dot(down), run = -normal.dot(along);
    if (run > 1e-12) {
      slope = std::max(slope, rise / run);
    } else if (rise > 1e-12) {
      slope = std::numeric_limits<double>::infinity();
    }
  };
  add(tiles.wall_normal(tile, at_start ? prev3(edge) : next3(edge)));
  for (const TruncationPlane& plane : truncation.of_tile[tile]) {
    if (plane.vertex == vertex) add(plane.plane.normal);
  }
  return slope;
}

// Contact points 2 and 3 at the ends of the polygon's deepest edge, and their count.
void set_back_points(ContactPatch& patch) {
  const Vec3 start = patch.point[0], along = (patch.point[1] - start).normalized();
  auto depth = [&](const Vec3& p) {
    const Vec3 d = p - start;
    return (d - d.dot(along) * along).norm();
  };
  double deepest = 0;
  for (const Vec3& p : patch.polygon) deepest = std::max(deepest, depth(p));
  const Vec3 *first = nullptr, *last = nullptr;
  for (const Vec3& p : patch.polygon) {
    if (depth(p) < deepest - tolerance::snap) continue;
    if (!first || (p - *first).dot(along) < 0) first = &p;
    if (!last || (p - *last).dot(along) > 0) last = &p;
  }
  if (deepest < tolerance::short_interface) {
    patch.point_count = 2;
    patch.point[2] = patch.point[3] = 0.5 * (patch.point[0] + patch.point[1]);
    patch.polygon = {patch.point[0], patch.point[1]};
  } else if ((*last - *first).norm() >= tolerance::short_interface) {
    patch.point_count = 4;
    patch.point[2] = *last;
    patch.point[3] = *first;
  } else {
    patch.point_count = 3;
    patch.point[2] = patch.point[3] = 0.5 * (*first + *last);
  }
}

}  // namespace

std::vector<ContactPatch> compute_contact_patches(const TileMesh& tiles,
                                                  const Truncation& truncation) {
  std::vector<ContactPatch> patches(tiles.contacts.size());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Contact& contact = tiles.contacts[k];
    ContactPatch& patch = patches[k];
    const int i = contact.tile[0], t = contact.side[0];
    const RigidMotion& frame = tiles.frame[i];
    const Vec3 start = tiles.mesh.V.row(tiles.mesh.F(i, t)),
               end = tiles.mesh.V.row(tiles.mesh.F(i, next3(t)));
    const double length = tiles.length(i, t);
    const Vec3 along = (end - start) / length;
    const double half = 0.5 * tiles.dihedral(i, t);
    const Vec2 in = tiles.inward(i, t);
    const Vec3 down =
        frame.R * Vec3(std::sin(half) * in.x(), std::sin(half) * in.y(), -std::cos(half));
    const double height = tiles.H_body / std::cos(half);
    patch.normal = frame.R * tiles.wall_normal(i, t);
    const int j = contact.tile[1], u = contact.side[1];
    const double at_start =
        std::max(slope_at(tiles, truncation, i, t, true), slope_at(tiles, truncation, j, u, false));
    const double at_end =
        std::max(slope_at(tiles, truncation, i, t, false), slope_at(tiles, truncation, j, u, true));
    auto point = [&](double a, double w) { return Vec3(start + a * along + w * down); };
    const double left = height * at_start, right = length - height * at_end;
    patch.point[0] = start;
    patch.point[1] = end;
    patch.polygon = {start, end};
    if (right > left) {
      patch.polygon.push_back(point(right, height));
      patch.polygon.push_back(point(left, height));
    } else if (std::isfinite(at_start + at_end)) {
      // The two ends' rays meet above the back: a triangle.
      const double depth = length / (at_start + at_end);
      patch.polygon.push_back(point(depth * at_start, depth));
    }
    set_back_points(patch);
    // Seen from tile[1] the outline runs the other way round.
    if (along.cross(down).dot(patch.normal) < 0)
      std::reverse(patch.polygon.begin(), patch.polygon.end());
  }
  return patches;
}

void clip_patch(ContactPatch& patch, const Plane& plane) {
  if (patch.point_count == 2) return;
  std::vector<Vec3> kept;
  const std::size_t n = patch.polygon.size();
  bool cuts = false;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 &a = patch.polygon[k], &b = patch.polygon[(k + 1) % n];
    const double da = plane.distance(a), db = plane.distance(b);
    if (da <= tolerance::snap) kept.push_back(a);
    cuts |= da > tolerance::snap;
    if ((da > tolerance::snap && db < -tolerance::snap) ||
        (da < -tolerance::snap && db > tolerance::snap)) {
      kept.push_back(a + (da / (da - db)) * (b - a));
    }
  }
  if (!cuts) return;
  patch.polygon = std::move(kept);
  set_back_points(patch);
}

}  // namespace curveups
