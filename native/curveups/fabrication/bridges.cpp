// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/bridges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

// Twice the smallest feature of the coarsest printer (FDM), half of it above the notches.
constexpr double bridge_thickness = 0.8, bridge_notch = 0.2;
constexpr double clearance = 0.1;  // from back and front faces, and bumps of its own two bodies, mm
constexpr double apart =
    0.3;  // from others at least: the widest gap that a printer of ours asks for

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
  const Vec2 from = span.middle + span.from * span.d, to = span.middle + span.to * span.d;
  return make_prism({from - side, to - side, to + side, from + side}, z0, z1);
}

bool contains(const ConvexBody& body, const Vec3& p) {
  for (const BodyFace& face : body.faces) {
    if (face.plane.distance(p) > 1e-9) return false;
  }
  return true;
}

// The box with a notch in its underside at either wall: on that side, the back, users break them,
// and whoever prints it front side down prints notches that are open at their top.
PrintBody notched(const Span& span, double z0, double z1) {
  const double gap = span.wall_to - span.wall_from;
  const double half = std::min(bridge_notch, 0.24 * gap);
  std::vector<std::array<double, 2>> profile{{span.from, z0}};
  if (half > 1e-3) {
    for (double s : {span.wall_from + 1.02 * half, span.wall_to - 1.02 * half}) {
      profile.push_back({s - half, z0});
      profile.push_back({s, z0 + 2 * bridge_notch});
      profile.push_back({s + half, z0});
    }
  }
  profile.insert(profile.end(), {{span.to, z0}, {span.to, z1}, {span.from, z1}});
  PrintBody body;
  body.kind = BodyKind::support;
  const Vec2 across = -left_of(span.d);  // d x z
  std::vector<int> base;
  for (const auto& [s, z] : profile) {
    const Vec2 q = span.middle + s * span.d - 0.5 * bridge_width * across;
    base.push_back(static_cast<int>(body.points.size()));
    body.points.emplace_back(q.x(), q.y(), z);
  }
  const Vec3 normal(across.x(), across.y(), 0);
  PlanarFace first, second;
  first.normal = -normal;
  first.outer.points.assign(base.rbegin(), base.rend());
  second.normal = normal;
  second.outer.points = extrude(body, base, bridge_width * normal, FaceRole::plain);
  body.faces.push_back(std::move(first));
  body.faces.push_back(std::move(second));
  return body;
}

std::optional<Span> find_span(const ConvexBody& a, const ConvexBody& b,
                              const std::array<Vec2, 2>& sight, double z0, double z1) {
  Span span{sight[0], sight[1], 1e300, -1e300, -1e300, 1e300};
  const Vec2 side = 0.5 * bridge_width * left_of(span.d);
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
  span.from -= bridge_depth;
  span.to += bridge_depth;
  for (const Vec3& q : corners) {
    if (!contains(a, q + span.from * d) || !contains(b, q + span.to * d)) return std::nullopt;
  }
  return span;
}

// The bridges made so far.
class TakenPlaces {
 public:
  bool clear_of(const ConvexBody& bridge) const {
    const Box box = bounding_box(bridge);
    for (std::size_t k = 0; k < bridges_.size(); ++k) {
      const Vec3 between = (box.low - boxes_[k].high).cwiseMax(boxes_[k].low - box.high);
      if (between.maxCoeff() < apart && distance(bridges_[k], bridge) < apart) return false;
    }
    return true;
  }
  void add(ConvexBody bridge) {
    boxes_.push_back(bounding_box(bridge));
    bridges_.push_back(std::move(bridge));
  }

 private:
  std::vector<Box> boxes_;
  std::vector<ConvexBody> bridges_;
};

double thickness(const Parameters& p) {
  return std::min(bridge_thickness, p.H_body - 2 * clearance);
}

}  // namespace

double bridge_neck(const Parameters& p) { return thickness(p) - 2 * bridge_notch; }

Bridges make_bridges(const std::vector<BridgeObstacle>& bodies,
                     const std::vector<BridgeWish>& wishes, double z, const Parameters& p) {
  const double z0 = z + clearance, z1 = z0 + thickness(p);
  if (z1 - z0 < 2.5 * bridge_notch) {
    throw InfeasibleDesign("the tiles are too thin for breakaway bridges",
                           "raise H_body, or choose another support");
  }
  const double gap = std::max(apart, p.d_gap_min);  // from third bodies, as these from one another
  const double reach = std::max(2.0, gap);
  const int count = static_cast<int>(bodies.size());
  Points3 low(count, 3), high(count, 3);
  for (int i = 0; i < count; ++i) {
    Box box = bounding_box(bodies[i].body);
    for (std::size_t k = 0; k < bodies[i].ball_centres.size(); ++k) {
      box.add(bodies[i].ball_centres[k] - Vec3::Constant(bodies[i].ball_radii[k]));
      box.add(bodies[i].ball_centres[k] + Vec3::Constant(bodies[i].ball_radii[k]));
    }
    low.row(i) = (box.low - Vec3::Constant(reach)).transpose();
    high.row(i) = (box.high + Vec3::Constant(reach)).transpose();
  }
  std::vector<std::vector<int>> near(count);
  for (const auto& [i, j] : overlapping_boxes(low, high)) {
    near[i].push_back(j);
    near[j].push_back(i);
  }
  auto free = [&](const ConvexBody& box, int a, int b) {
    auto clear_of = [&](int i) {
      const BridgeObstacle& body = bodies[i];
      const bool own = i == a || i == b;
      const double keep = own ? clearance : gap;
      for (std::size_t k = 0; k < body.ball_centres.size(); ++k) {
        const Vec3& c = body.ball_centres[k];
        if ((nearest_point(box, c) - c).norm() < body.ball_radii[k] + keep) return false;
      }
      return own || distance(box, body.body) >= gap;
    };
    if (!clear_of(a) || !clear_of(b)) return false;
    for (int i : near[a]) {
      if (!clear_of(i)) return false;
    }
    return std::all_of(near[b].begin(), near[b].end(), clear_of);
  };
  // The next line of sight from `from` on that is free; nothing where there is none.
  struct Place {
    std::size_t sight;
    Span span;
    ConvexBody box;
  };
  auto next_free = [&](const BridgeWish& wish, std::size_t from) -> std::optional<Place> {
    for (std::size_t k = from; k < wish.sight.size(); ++k) {
      const auto span = find_span(bodies[wish.a].body, bodies[wish.b].body, wish.sight[k], z0, z1);
      if (!span) continue;
      ConvexBody box = box_of(*span, bridge_width, z0, z1);
      if (free(box, wish.a, wish.b)) return Place{k, *span, std::move(box)};
    }
    return std::nullopt;
  };
  std::vector<std::optional<Place>> best(wishes.size());
  parallel_for(static_cast<int>(wishes.size()), [&](int w) { best[w] = next_free(wishes[w], 0); });
  // Bridges keep clear of one another as well, the earlier wish first.
  Bridges out;
  TakenPlaces taken;
  std::vector<int> ending(count, 0);  // bridges at each body
  for (std::size_t w = 0; w < wishes.size(); ++w) {
    checkpoint();
    const BridgeWish& wish = wishes[w];
    if (wish.enough > 0 && ending[wish.b] >= wish.enough) continue;
    std::optional<Place>& place = best[w];
    while (place && !taken.clear_of(place->box)) place = next_free(wish, place->sight + 1);
    if (!place) continue;
    ++ending[wish.a];
    ++ending[wish.b];
    out.bodies.push_back(notched(place->span, z0, z1));
    out.joined.push_back({wish.a, wish.b});
    taken.add(std::move(place->box));
  }
  return out;
}

}  // namespace curveups
