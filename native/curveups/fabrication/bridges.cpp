// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/bridges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

constexpr double clearance = 0.1;  // from back and front faces, bumps and third bodies, mm

// How far from p along d the convex body begins; nothing where the line passes it by.
std::optional<double> entry(const ConvexBody& body, const Vec3& p, const Vec3& d) {
  double enter = -1e300, leave = 1e300;
  for (const BodyFace& face : body.faces) {
    const double height = face.plane.distance(p), slope = face.plane.normal.dot(d);
    if (std::abs(slope) < 1e-12) {
      if (height > 0) return std::nullopt;
    } else if (slope < 0) {
      enter = std::max(enter, -height / slope);
    } else {
      leave = std::min(leave, -height / slope);
    }
  }
  if (enter > leave || leave < 0) return std::nullopt;
  return enter;
}

// A bridge before it is made: along `d` from `from` to `to` (relative to `middle`).
struct Span {
  Vec2 middle, d;
  double from, to;            // the ends, inside the bodies
  double wall_from, wall_to;  // where the gap begins and ends on the whole width
};

ConvexBody box_of(const Span& span, double width, double z0, double z1) {
  const Vec2 side = 0.5 * width * left_of(span.d);
  ConvexBody box;
  for (double z : {z0, z1}) {
    for (const Vec2& p :
         {Vec2(span.middle + span.from * span.d - side),
          Vec2(span.middle + span.to * span.d - side), Vec2(span.middle + span.to * span.d + side),
          Vec2(span.middle + span.from * span.d + side)}) {
      box.points.emplace_back(p.x(), p.y(), z);
    }
  }
  const std::vector<std::vector<int>> loops = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const std::vector<int>& loop : loops) {
    const Vec3& o = box.points[loop[0]];
    const Vec3 n = (box.points[loop[1]] - o).cross(box.points[loop[2]] - o).normalized();
    box.faces.push_back({loop, body_tag::wall, {n, n.dot(o)}});
  }
  return box;
}

bool contains(const ConvexBody& body, const Vec3& p) {
  for (const BodyFace& face : body.faces) {
    if (face.plane.distance(p) > 1e-9) return false;
  }
  return true;
}

// The box with a notch in its underside and its top at either wall.
PrintBody notched(const Span& span, const Parameters& p, double z0, double z1) {
  const double gap = span.wall_to - span.wall_from;
  const double half = std::min(p.bridge_notch, 0.24 * gap);
  std::vector<std::array<double, 2>> below{{span.from, z0}}, above{{span.to, z1}};
  if (p.bridge_notch > 0 && half > 1e-3) {
    for (double s : {span.wall_from + half, span.wall_to - half}) {
      below.push_back({s - half, z0});
      below.push_back({s, z0 + p.bridge_notch});
      below.push_back({s + half, z0});
    }
    for (double s : {span.wall_to - half, span.wall_from + half}) {
      above.push_back({s + half, z1});
      above.push_back({s, z1 - p.bridge_notch});
      above.push_back({s - half, z1});
    }
  }
  below.push_back({span.to, z0});
  above.push_back({span.from, z1});
  below.insert(below.end(), above.begin(), above.end());
  PrintBody body;
  body.kind = BodyKind::support;
  const Vec2 across = -left_of(span.d);  // d x z
  std::vector<int> base;
  for (const auto& [s, z] : below) {
    const Vec2 q = span.middle + s * span.d - 0.5 * p.bridge_width * across;
    base.push_back(static_cast<int>(body.points.size()));
    body.points.emplace_back(q.x(), q.y(), z);
  }
  const Vec3 normal(across.x(), across.y(), 0);
  PlanarFace first, second;
  first.normal = -normal;
  first.outer.points.assign(base.rbegin(), base.rend());
  second.normal = normal;
  second.outer.points = extrude(body, base, p.bridge_width * normal, FaceRole::plain);
  body.faces.push_back(std::move(first));
  body.faces.push_back(std::move(second));
  return body;
}

std::optional<Span> find_span(const ConvexBody& a, const ConvexBody& b,
                              const std::array<Vec2, 2>& sight, double z0, double z1,
                              const Parameters& p) {
  Span span{sight[0], sight[1], 1e300, -1e300, -1e300, 1e300};
  const Vec2 side = 0.5 * p.bridge_width * left_of(span.d);
  const Vec3 d(span.d.x(), span.d.y(), 0);
  std::vector<Vec3> corners;
  for (double z : {z0, z1}) {
    for (double s : {-1.0, 1.0}) {
      const Vec2 q = span.middle + s * side;
      corners.emplace_back(q.x(), q.y(), z);
    }
  }
  for (const Vec3& q : corners) {
    const auto back = entry(a, q, -d), forth = entry(b, q, d);
    if (!back || !forth) return std::nullopt;
    span.from = std::min(span.from, -*back);
    span.wall_from = std::max(span.wall_from, -*back);
    span.to = std::max(span.to, *forth);
    span.wall_to = std::min(span.wall_to, *forth);
  }
  if (span.wall_to - span.wall_from < 0.05) return std::nullopt;
  span.from -= p.bridge_depth;
  span.to += p.bridge_depth;
  for (const Vec3& q : corners) {
    if (!contains(a, q + span.from * d) || !contains(b, q + span.to * d)) return std::nullopt;
  }
  return span;
}

double thickness(const Parameters& p) {
  return std::min(p.bridge_thickness, p.H_body - 2 * clearance);
}

}  // namespace

double bridge_neck(const Parameters& p) { return thickness(p) - 2 * p.bridge_notch; }

Bridges make_bridges(const std::vector<BridgeObstacle>& bodies,
                     const std::vector<BridgeWish>& wishes, double z, const Parameters& p) {
  const double z0 = z + clearance, z1 = z0 + thickness(p);
  if (z1 - z0 < std::max(0.1, 2.5 * p.bridge_notch)) {
    throw InfeasibleDesign("the tiles are too thin for breakaway bridges",
                           "raise H_body or lower bridge_notch, or choose another support");
  }
  const int count = static_cast<int>(bodies.size());
  Points3 low(count, 3), high(count, 3);
  for (int i = 0; i < count; ++i) {
    Box box = bounding_box(bodies[i].body);
    for (std::size_t k = 0; k < bodies[i].ball_centres.size(); ++k) {
      box.add(bodies[i].ball_centres[k] - Vec3::Constant(bodies[i].ball_radii[k]));
      box.add(bodies[i].ball_centres[k] + Vec3::Constant(bodies[i].ball_radii[k]));
    }
    low.row(i) = (box.low - Vec3::Constant(2.0)).transpose();
    high.row(i) = (box.high + Vec3::Constant(2.0)).transpose();
  }
  std::vector<std::vector<int>> near(count);
  for (const auto& [i, j] : overlapping_boxes(low, high)) {
    near[i].push_back(j);
    near[j].push_back(i);
  }
  auto free = [&](const ConvexBody& box, int a, int b) {
    auto clear_of = [&](int i) {
      const BridgeObstacle& body = bodies[i];
      for (std::size_t k = 0; k < body.ball_centres.size(); ++k) {
        const Vec3& c = body.ball_centres[k];
        if ((nearest_point(box, c) - c).norm() < body.ball_radii[k] + clearance) return false;
      }
      return i == a || i == b || distance(box, body.body) >= clearance;
    };
    if (!clear_of(a) || !clear_of(b)) return false;
    for (int i : near[a]) {
      if (!clear_of(i)) return false;
    }
    return std::all_of(near[b].begin(), near[b].end(), clear_of);
  };
  std::vector<std::optional<PrintBody>> made(wishes.size());
  parallel_ranges(static_cast<int>(wishes.size()), [&](int begin, int end) {
    for (int w = begin; w < end; ++w) {
      const BridgeWish& wish = wishes[w];
      for (const auto& sight : wish.sight) {
        const auto span = find_span(bodies[wish.a].body, bodies[wish.b].body, sight, z0, z1, p);
        if (!span || !free(box_of(*span, p.bridge_width, z0, z1), wish.a, wish.b)) continue;
        made[w] = notched(*span, p, z0, z1);
        break;
      }
    }
  });
  Bridges out;
  for (std::size_t w = 0; w < wishes.size(); ++w) {
    if (!made[w]) continue;
    out.bodies.push_back(std::move(*made[w]));
    out.joined.push_back({wishes[w].a, wishes[w].b});
  }
  return out;
}

}  // namespace curveups
