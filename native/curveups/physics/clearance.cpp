// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/clearance.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// mm. Bodies that touch have edges in common: of those as near as this the last is taken, so that
// what is done about it does not hang on last digits.
constexpr double as_near = 1e-9;

void take_nearer(double distance, int tile, int patch, MembraneClearance& best) {
  if (distance < best.distance + as_near) best = {std::min(distance, best.distance), tile, patch};
}

double segment_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  double s =
      determinant > 1e-14 * uu * vv ? std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0) : 0;
  double t = vv > 0 ? (uv * s + vw) / vv : 0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0;
  }
  return (w + s * u - t * v).norm();
}

// Where p's foot on the plane lies inside the triangle: its height; else infinite (an edge is
// nearer).
double height_over(const Vec3& p, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (int e = 0; e < 3; ++e) {
    if (normal.dot((t[next3(e)] - t[e]).cross(p - t[e])) < 0) return 1e300;
  }
  return std::abs(normal.dot(p - t[0])) / normal.norm();
}

bool pierces(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double a = normal.dot(p - t[0]), b = normal.dot(q - t[0]);
  if ((a > 0) == (b > 0)) return false;
  const Vec3 at = p + (q - p) * (a / (a - b));
  return height_over(at, t) < 1e300;
}

// Depth of the part of a triangle that lies in a tile's body: how deep below the face, at most,
// inside its walls. Clipped by the walls one after another.
double depth_in_body(const std::array<Vec3, 3>& local, const ConvexBody& body, int face_tag) {
  std::vector<Vec3> polygon(local.begin(), local.end());
  const Plane* face = nullptr;
  for (const BodyFace& f : body.faces) {
    if (f.tag == face_tag) {
      face = &f.plane;
      continue;
    }
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double a = f.plane.distance(p), b = f.plane.distance(q);
      if (a <= 0) kept.push_back(p);
      if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(p + (q - p) * (a / (a - b)));
    }
    polygon = std::move(kept);
  }
  double depth = 0;
  if (face) {
    for (const Vec3& p : polygon) depth = std::max(depth, -face->distance(p));
  }
  return depth;
}

}  // namespace

double triangle_distance(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  double least = 1e300;
  for (int i = 0; i < 3; ++i) {
    if (pierces(a[i], a[next3(i)], b) || pierces(b[i], b[next3(i)], a)) return 0;
    least = std::min({least, height_over(a[i], b), height_over(b[i], a)});
    for (int j = 0; j < 3; ++j) {
      least = std::min(least, segment_distance(a[i], a[next3(i)], b[j], b[next3(j)]));
    }
  }
  return least;
}

std::vector<MembraneClearance> patch_clearances(const DesignGeometry& geometry,
                                                const MembraneSolution& membrane, double H_pin) {
  const TileMesh& tiles = geometry.tiles;
  const bool front = membrane.domain.side == Side::front;
  const int tag = front ? body_tag::front : body_tag::back;
  const std::vector<MembranePatch>& patches = membrane.domain.patches;
  // Triangles are stored patch by patch.
  const std::vector<int>& patch_of = membrane.mesh.patch;
  std::vector<std::size_t> first(patches.size() + 1, patch_of.size());
  for (std::size_t t = patch_of.size(); t-- > 0;) first[patch_of[t]] = t;
  for (std::size_t p = patches.size(); p-- > 0;) {
    if (first[p] == patch_of.size()) first[p] = first[p + 1];
  }
  std::vector<ConvexBody> bodies(tiles.tile_count());
  parallel_ranges(tiles.tile_count(), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) bodies[i] = tile_body(tiles, geometry.truncation, i);
  });
  std::vector<MembraneClearance> of_patch(patches.size());
  parallel_ranges(static_cast<int>(patches.size()), [&](int begin, int end) {
    for (int p = begin; p < end; ++p) {
      MembraneClearance& best = of_patch[p];
      best = {H_pin, -1, p};
      for (int tile : tiles_of(patches[p])) {
        const ConvexBody& body = bodies[tile];
        const BodyFace* face = nullptr;
        for (const BodyFace& f : body.faces) {
          if (f.tag == tag) face = &f;
        }
        if (!face) continue;
        for (std::size_t t = first[p]; t < first[p + 1]; ++t) {
          std::array<Vec3, 3> local;
          double lowest = 1e300;
          for (int c = 0; c < 3; ++c) {
            local[c] = tiles.frame[tile].to_own(
                membrane.state.x.row(membrane.mesh.triangles[t][c]).transpose());
            lowest = std::min(lowest, face->plane.distance(local[c]));
          }
          // The body lies behind its face: nothing nearer than this.
          if (lowest >= best.distance + as_near) continue;
          double distance = 1e300;
          for (std::size_t k = 1; k + 1 < face->loop.size(); ++k) {
            distance = std::min(
                distance,
                triangle_distance(local, {body.points[face->loop[0]], body.points[face->loop[k]],
                                          body.points[face->loop[k + 1]]}));
          }
          const double depth = lowest < 0 ? depth_in_body(local, body, tag) : 0;
          if (depth > 0) distance = -depth;
          take_nearer(distance, tile, p, best);
        }
      }
    }
  });
  return of_patch;
}

MembraneClearance least_clearance(const std::vector<MembraneClearance>& of_patches, double H_pin) {
  MembraneClearance best{H_pin, -1, -1};
  for (const MembraneClearance& one : of_patches) {
    if (one.tile >= 0) take_nearer(one.distance, one.tile, one.patch, best);
  }
  return best;
}

}  // namespace curveups
