// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/remote_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

using Corners = std::array<Vec3, 6>;  // front, then back, in world coordinates

Corners world_corners(const TileMesh& tiles, int tile) {
  Corners corners;
  for (int t = 0; t < 3; ++t) {
    const Vec2 &f = tiles.front[tile][t], &b = tiles.back[tile][t];
    corners[t] = tiles.frame[tile](Vec3(f.x(), f.y(), 0));
    corners[t + 3] = tiles.frame[tile](Vec3(b.x(), b.y(), -tiles.H_body));
  }
  return corners;
}

std::array<Plane, 5> face_planes(const Corners& c) {
  std::array<Plane, 5> planes;
  auto through = [](const Vec3& a, const Vec3& b, const Vec3& d) {
    const Vec3 normal = (b - a).cross(d - a).normalized();
    return Plane{normal, normal.dot(a)};
  };
  planes[0] = through(c[0], c[1], c[2]);
  planes[1] = {-planes[0].normal, -planes[0].normal.dot(c[3])};
  for (int t = 0; t < 3; ++t) planes[2 + t] = through(c[t], c[t + 3], c[next3(t)]);
  return planes;
}

bool apart(const std::array<Plane, 5>& planes, const Corners& other) {
  return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return std::all_of(other.begin(), other.end(),
                       [&](const Vec3& p) { return plane.distance(p) >= -tolerance::snap; });
  });
}

// The truncated bodies overlap by more than the tolerance.
bool bodies_overlap(const TileMesh& tiles, const Truncation& truncation, int i, int j) {
  ConvexBody body = tile_body(tiles, truncation, i);
  const ConvexBody other = tile_body(tiles, truncation, j);
  const RigidMotion &to = tiles.frame[i], &from = tiles.frame[j];
  for (const BodyFace& face : other.faces) {
    const Vec3 normal = to.R.transpose() * (from.R * face.plane.normal);
    const Vec3 point = to.to_own(from(other.points[face.loop[0]]));
    clip(body, {normal, normal.dot(point)}, body_tag::cut);
    if (body.faces.empty()) return false;
  }
  return volume(body) > 0.1 * tolerance::overlap_volume;
}

// Points that a tile must keep, and the middle of its body.
struct Kept {
  std::vector<Vec3> points;
  Vec3 middle;
};

// Plane half-way between the convex hulls of the points that two tiles keep, along a separating
// axis: a face normal of one of them or the cross product of two edges. Of all such planes the
// farthest from both bodies' middles, which takes the least away. False where the hulls overlap,
// true where they touch.
bool separating_plane(const Kept& a, const Kept& b, Plane& plane) {
  double best = 0;
  auto test = [&](Vec3 axis) {
    const double norm = axis.norm();
    if (norm < 1e-9) return;
    axis /= norm;
    if (axis.dot(b.middle - a.middle) < 0) axis = -axis;
    double a_high = -std::numeric_limits<double>::infinity(), b_low = -a_high;
    for (const Vec3& p : a.points) a_high = std::max(a_high, axis.dot(p));
    for (const Vec3& p : b.points) b_low = std::min(b_low, axis.dot(p));
    if (b_low - a_high < -tolerance::snap) return;
    const Plane candidate{axis, 0.5 * (a_high + b_low)};
    const double clearance = std::min(-candidate.distance(a.middle), candidate.distance(b.middle));
    if (clearance <= best) return;
    best = clearance;
    plane = candidate;
  };
  auto edges = [](const std::vector<Vec3>& points) {
    std::vector<Vec3> out;
    for (std::size_t m = 0; m < points.size(); ++m) {
      for (std::size_t n = m + 1; n < points.size(); ++n) out.push_back(points[n] - points[m]);
    }
    return out;
  };
  const std::vector<Vec3> edges_a = edges(a.points), edges_b = edges(b.points);
  for (const std::vector<Vec3>* own : {&edges_a, &edges_b}) {
    for (std::size_t m = 0; m < own->size(); ++m) {
      for (std::size_t n = m + 1; n < own->size(); ++n) test((*own)[m].cross((*own)[n]));
    }
  }
  for (const Vec3& p : edges_a) {
    for (const Vec3& q : edges_b) test(p.cross(q));
  }
  // Hulls that share an edge (the lips of a slit): between their faces.
  const Vec3 normal_a = (a.points[1] - a.points[0]).cross(a.points[2] - a.points[0]).normalized(),
             normal_b = (b.points[1] - b.points[0]).cross(b.points[2] - b.points[0]).normalized();
  for (const Vec3& e : edges_a) test(e.cross(normal_a + normal_b));
  for (const Vec3& e : edges_b) test(e.cross(normal_a + normal_b));
  return best > 0;
}

// Adds the back points of an interface, drawn together to `share` of their distance.
void keep_back_edge(const ContactPatch& patch, double share, std::vector<Vec3>& points) {
  if (patch.point_count == 3) {
    const Vec3 front = 0.5 * (patch.point[0] + patch.point[1]);
    points.push_back(front + share * (patch.point[2] - front));
  } else if (patch.point_count == 4) {
    const Vec3 middle = 0.5 * (patch.point[2] + patch.point[3]);
    for (int l : {2, 3}) points.push_back(middle + share * (patch.point[l] - middle));
  }
}

std::vector<std::array<int, 2>> near_pairs(const std::vector<Corners>& corners) {
  std::vector<Eigen::AlignedBox3d> boxes(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const Vec3& p : corners[i]) boxes[i].extend(p);
  }
  return overlapping_boxes(boxes);
}

// Keeps the first tile behind the plane (world) and the second before it.
void bound_both(const TileMesh& tiles, const std::array<int, 2>& pair, const Plane& plane,
                std::vector<std::vector<TruncationPlane>>& planes) {
  for (int s = 0; s < 2; ++s) {
    const RigidMotion& frame = tiles.frame[pair[s]];
    const double sign = s == 0 ? 1.0 : -1.0;
    const Vec3 normal = frame.R.transpose() * (sign * plane.normal);
    const double offset = sign * (plane.offset - plane.normal.dot(frame.t));
    planes[pair[s]].push_back({{normal, offset}, pair[1 - s], -1, 4});
  }
}

// Plane in the middle of the overlap of two prisms along the axis on which they overlap least.
// False where they do not overlap.
bool middle_plane(const Corners& a, const Corners& b, Plane& plane) {
  double least = std::numeric_limits<double>::infinity();
  auto test = [&](Vec3 axis) {
    const double norm = axis.norm();
    if (norm < 1e-9) return;
    axis /= norm;
    double a_low = std::numeric_limits<double>::infinity(), a_high = -a_low, b_low = a_low,
           b_high = -a_low;
    for (int k = 0; k < 6; ++k) {
      const double in_a = axis.dot(a[k]), in_b = axis.dot(b[k]);
      a_low = std::min(a_low, in_a);
      a_high = std::max(a_high, in_a);
      b_low = std::min(b_low, in_b);
      b_high = std::max(b_high, in_b);
    }
    if (a_high - b_low < least) {
      least = a_high - b_low;
      plane = {axis, 0.5 * (a_high + b_low)};
    }
    if (b_high - a_low < least) {
      least = b_high - a_low;
      plane = {-axis, -0.5 * (b_high + a_low)};
    }
  };
  for (const Plane& face : face_planes(a)) test(face.normal);
  for (const Plane& face : face_planes(b)) test(face.normal);
  auto edges = [](const Corners& c) {
    return std::array<Vec3, 4>{c[1] - c[0], c[2] - c[1], c[0] - c[2], c[3] - c[0]};
  };
  for (const Vec3& p : edges(a)) {
    for (const Vec3& q : edges(b)) test(p.cross(q));
  }
  return least > tolerance::snap;
}

}  // namespace

bool share_vertex(const Triangles& F, int i, int j) {
  for (int s = 0; s < 3; ++s) {
    for (int t = 0; t < 3; ++t) {
      if (F(i, s) == F(j, t)) return true;
    }
  }
  return false;
}

void separate_remote_tiles(const TileMesh& tiles, std::vector<ContactPatch>& patches,
                           Truncation& truncation) {
  const int count = tiles.tile_count();
  std::vector<Corners> corners(count);
  std::vector<std::array<Plane, 5>> planes(count);
  for (int i = 0; i < count; ++i) {
    corners[i] = world_corners(tiles, i);
    planes[i] = face_planes(corners[i]);
  }
  std::vector<std::vector<int>> patches_of(count);
  bool listed = false;
  for (const std::array<int, 2>& pair : near_pairs(corners)) {
    const auto [i, j] = pair;
    if (share_vertex(tiles.mesh.F, i, j)) continue;
    if (apart(planes[i], corners[j]) || apart(planes[j], corners[i])) continue;
    if (!bodies_overlap(tiles, truncation, i, j)) continue;
    if (!listed) {
      for (std::size_t k = 0; k < patches.size(); ++k) {
        for (int tile : tiles.contacts[k].tile) patches_of[tile].push_back(static_cast<int>(k));
      }
      listed = true;
    }
    Plane plane{Vec3::Zero(), 0};
    bool separated = false, whole = true;
    for (double share : {1.0, 0.75, 0.5, 0.25}) {
      whole = share == 1.0;
      std::array<Kept, 2> keep;
      for (int s = 0; s < 2; ++s) {
        const Corners& own = corners[pair[s]];
        keep[s].points.assign(own.begin(), own.begin() + 3);
        for (int k : patches_of[pair[s]]) keep_back_edge(patches[k], share, keep[s].points);
        keep[s].middle = Vec3::Zero();
        for (const Vec3& p : own) keep[s].middle += p / 6;
      }
      separated = separating_plane(keep[0], keep[1], plane);
      if (separated) break;
    }
    if (!separated) {
      truncation.unresolved.push_back(pair);
      continue;
    }
    ++truncation.pairs_of_type[4];
    if (!whole) truncation.shortened.push_back(pair);
    bound_both(tiles, pair, plane, truncation.of_tile);
    for (int s = 0; s < 2; ++s) {
      const double sign = s == 0 ? 1.0 : -1.0;
      const Plane world{sign * plane.normal, sign * plane.offset};
      for (int k : patches_of[pair[s]]) clip_patch(patches[k], world);
    }
  }
}

void separate_remote_front_pins(const TileMesh& tiles, double H_pin, Truncation& truncation) {
  const int count = tiles.tile_count();
  std::vector<Corners> corners(count);  // the pins' tops, then their feet
  for (int i = 0; i < count; ++i) {
    for (int t = 0; t < 3; ++t) {
      const Vec2& p = tiles.front[i][t];
      corners[i][t] = tiles.frame[i](Vec3(p.x(), p.y(), H_pin));
      corners[i][t + 3] = tiles.frame[i](Vec3(p.x(), p.y(), 0));
    }
  }
  Plane plane{Vec3::Zero(), 0};
  for (const std::array<int, 2>& pair : near_pairs(corners)) {
    if (share_vertex(tiles.mesh.F, pair[0], pair[1])) continue;
    if (!middle_plane(corners[pair[0]], corners[pair[1]], plane)) continue;
    bound_both(tiles, pair, plane, truncation.front_pins);
  }
}

}  // namespace curveups
