// SPDX-License-Identifier: LGPL-2.1-or-later
// Breakaway support: thin bridges between neighbouring bodies. They lie just above the back faces:
// the front membrane is glued first, and the bridges are then broken from the back.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/disjoint_sets.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/supports.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

// Twice the smallest feature of the coarsest printer (FDM), half of it above the notches.
constexpr double bridge_thickness = 0.8, bridge_notch = 0.2;
constexpr double clearance =
    0.1;                       // from back and front faces, and from bumps of its two bodies, mm
constexpr double apart = 0.3;  // from other bodies and bridges, mm: the widest gap of any printer
constexpr int bridges_of_anchor = 2;  // enough to hold it

// Two bodies to be joined, and lines of sight to try, the best ones first.
struct Wish {
  int a, b;
  std::vector<std::array<Vec2, 2>> sight;  // a point between the bodies, unit direction from a to b
  int most = 0;  // bridges at b, those of earlier wishes included; 0: any number
};

struct Bridges {
  std::vector<PrintBody> bodies;
  std::vector<std::array<int, 2>> joined;  // per bridge
};

// A body in print coordinates with balls (centre, radius) around its bumps and hollows.
struct Obstacle {
  ConvexBody body;
  std::vector<std::pair<Vec3, double>> balls = {};
};

// Distance along d from p to the body; none where the line passes it by.
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

// Extent of a bridge along `d`, from `middle`.
struct Span {
  Vec2 middle, d;
  double from, to;            // ends, inside the bodies
  double wall_from, wall_to;  // ends of the gap, on the whole width
};

ConvexBody box_of(const Span& span, double z0, double z1) {
  const Vec2 side = 0.5 * bridge_width * left_of(span.d);
  const Vec2 from = span.middle + span.from * span.d, to = span.middle + span.to * span.d;
  return make_prism({from - side, to - side, to + side, from + side}, z0, z1);
}

bool contains(const ConvexBody& body, const Vec3& p) {
  for (const BodyFace& face : body.faces) {
    if (face.plane.distance(p) > 1e-9) return false;
  }
  return true;
}

// Box with a notch in its underside at either wall. Users break bridges from that side, the back; a
// print with its front side down has the notches open at their top.
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

double thickness(const Parameters& p) {
  return std::min(bridge_thickness, p.H_body - 2 * clearance);
}

// Makes one bridge per wish where one of its lines of sight is free. A bridge enters both bodies by
// bridge_depth and keeps clear of their bumps, of bridges of earlier wishes and, by d_gap_min, of
// third bodies. z: height of the back faces.
Bridges make_bridges(const std::vector<Obstacle>& bodies, const std::vector<Wish>& wishes, double z,
                     const Parameters& p) {
  const double z0 = z + clearance, z1 = z0 + thickness(p);
  if (z1 - z0 < 2.5 * bridge_notch) {
    throw InfeasibleDesign("the tiles are too thin for breakaway bridges",
                           "raise H_body, or choose another support");
  }
  const double gap = std::max(apart, p.d_gap_min);
  const double reach = std::max(2.0, gap);
  const int count = static_cast<int>(bodies.size());
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Obstacle& obstacle : bodies) {
    Eigen::AlignedBox3d box = bounding_box(obstacle.body);
    for (const auto& [centre, radius] : obstacle.balls) {
      box.extend(centre - Vec3::Constant(radius));
      box.extend(centre + Vec3::Constant(radius));
    }
    boxes.push_back(grown(box, reach));
  }
  std::vector<std::vector<int>> near(count);
  for (const auto& [i, j] : overlapping_boxes(boxes)) {
    near[i].push_back(j);
    near[j].push_back(i);
  }
  const auto free = [&](const ConvexBody& box, int a, int b) {
    const auto clear_of = [&](int i) {
      const bool own = i == a || i == b;
      const double keep = own ? clearance : gap;
      for (const auto& [centre, radius] : bodies[i].balls) {
        if ((nearest_point(box, centre) - centre).norm() < radius + keep) return false;
      }
      return own || distance(box, bodies[i].body) >= gap;
    };
    return clear_of(a) && clear_of(b) && std::all_of(near[a].begin(), near[a].end(), clear_of) &&
           std::all_of(near[b].begin(), near[b].end(), clear_of);
  };
  struct Place {
    std::size_t sight;
    Span span;
    ConvexBody box;
  };
  // First free line of sight at or after `from`.
  const auto next_free = [&](const Wish& wish, std::size_t from) -> std::optional<Place> {
    for (std::size_t k = from; k < wish.sight.size(); ++k) {
      const auto span = find_span(bodies[wish.a].body, bodies[wish.b].body, wish.sight[k], z0, z1);
      if (!span) continue;
      ConvexBody box = box_of(*span, z0, z1);
      if (free(box, wish.a, wish.b)) return Place{k, *span, std::move(box)};
    }
    return std::nullopt;
  };
  std::vector<std::optional<Place>> best(wishes.size());
  parallel_for(static_cast<int>(wishes.size()), [&](int w) { best[w] = next_free(wishes[w], 0); });
  Bridges out;
  std::vector<std::pair<Eigen::AlignedBox3d, ConvexBody>> taken;
  const auto clear_of_taken = [&](const ConvexBody& bridge) {
    const Eigen::AlignedBox3d box = bounding_box(bridge);
    return std::all_of(taken.begin(), taken.end(), [&](const auto& other) {
      const Vec3 between = (box.min() - other.first.max()).cwiseMax(other.first.min() - box.max());
      return between.maxCoeff() >= apart || distance(other.second, bridge) >= apart;
    });
  };
  std::vector<int> bridges_at(count, 0);
  for (std::size_t w = 0; w < wishes.size(); ++w) {
    checkpoint();
    const Wish& wish = wishes[w];
    if (wish.most > 0 && bridges_at[wish.b] >= wish.most) continue;
    std::optional<Place>& place = best[w];
    while (place && !clear_of_taken(place->box)) place = next_free(wish, place->sight + 1);
    if (!place) continue;
    ++bridges_at[wish.a];
    ++bridges_at[wish.b];
    out.bodies.push_back(notched(place->span, z0, z1));
    out.joined.push_back({wish.a, wish.b});
    taken.emplace_back(bounding_box(place->box), std::move(place->box));
  }
  return out;
}

// Adds the anchor at c to the bodies, and wishes to join it to its piece's nearest tiles.
void add_anchor_wishes(const PrintModel& model, int piece, const Vec2& c, double height,
                       std::vector<Obstacle>& bodies, const std::vector<Polygon>& hull,
                       std::vector<Wish>& wishes) {
  const Parameters& p = model.parameters;
  constexpr int corners = 64;
  const double r = p.anchor_radius;
  Polygon circle;
  for (int i = 0; i < corners; ++i) {
    circle.push_back(c + PlaneRotation(2 * M_PI * i / corners) * Vec2(r, 0));
  }
  const int self = static_cast<int>(bodies.size());
  bodies.push_back({make_prism(circle, 0, height)});
  std::vector<std::pair<double, int>> near;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (model.piece_of_tile[i] == piece) near.emplace_back(distance(hull[i], c), i);
  }
  std::sort(near.begin(), near.end());
  if (near.size() > 8) near.resize(8);
  const std::vector<int>& part = model.division.part_of_tile;
  for (const auto& [gap, tile] : near) {
    if (!part.empty() && part[tile] != part[near.front().second]) continue;
    Wish wish{tile, self, {}, 1};
    std::vector<std::array<Vec2, 2>> beside;
    for (double s : {0.5, 0.3, 0.7, 0.15, 0.85}) {
      for (std::size_t e = 0; e < hull[tile].size(); ++e) {
        const Vec2 &a = hull[tile][e], &b = hull[tile][(e + 1) % hull[tile].size()];
        const Vec2 target = a + s * (b - a);
        if (wedge(b - a, c - a) >= 0 || (b - a).norm() < bridge_width) continue;
        // Towards the axis, or straight out of the wall.
        const Vec2 inwards = (c - target).normalized(), out = -left_of(b - a).normalized();
        wish.sight.push_back({0.5 * (target + c - r * inwards), inwards});
        beside.push_back({target + 0.5 * anchor_distance * out, out});
      }
    }
    wish.sight.insert(wish.sight.end(), beside.begin(), beside.end());
    wishes.push_back(std::move(wish));
  }
}

// Lists tiles and anchors that no bridges join to the largest part of their group. group: a piece,
// or a part of a divided one, per tile.
void find_loose(PrintModel& model, const Bridges& bridges, const std::vector<int>& group) {
  const int tile_count = static_cast<int>(group.size());
  DisjointSets joined(tile_count + model.anchors.size());
  for (const auto& [a, b] : bridges.joined) joined.unite(a, b);
  std::vector<int> size(tile_count + model.anchors.size(), 0),
      main(*std::max_element(group.begin(), group.end()) + 1, -1);
  for (int i = 0; i < tile_count; ++i) ++size[joined.find(i)];
  for (int i = 0; i < tile_count; ++i) {
    int& best = main[group[i]];
    if (best < 0 || size[joined.find(i)] > size[best]) best = joined.find(i);
  }
  for (int i = 0; i < tile_count; ++i) {
    if (joined.find(i) != main[group[i]]) model.loose_tiles.push_back(i);
  }
  for (std::size_t k = 0; k < model.anchors.size(); ++k) {
    if (joined.find(tile_count + static_cast<int>(k)) != main[model.anchors[k].piece]) {
      ++model.loose_anchors;
    }
  }
}

void add_bridges(PrintModel& model, const std::vector<PieceFootprint>& footprints) {
  const Parameters& p = model.parameters;
  const TileMesh& tiles = model.geometry.tiles;
  const int count = tiles.tile_count();
  const std::vector<int>& parts = model.division.part_of_tile;
  const std::vector<int>& group = parts.empty() ? model.piece_of_tile : parts;
  std::vector<Obstacle> bodies;
  std::vector<Polygon> hull;
  for (int i = 0; i < count; ++i) {
    Obstacle body{moved(model.bumps.body[i], model.flat[i])};
    for (const WallCap& cap : model.bumps.of_tile[i]) {
      body.balls.emplace_back(model.flat[i](cap.centre), cap.radius);
    }
    std::vector<Vec2> seen;
    for (const Vec3& q : body.body.points) seen.push_back(q.head<2>());
    hull.push_back(convex_hull(seen));
    bodies.push_back(std::move(body));
  }
  std::vector<Wish> wishes;
  // Anchors first: they have fewer places. Each has one bridge before any has its second.
  const double height = 2 * p.H_pin + p.H_body;
  for (int piece = 0; piece < model.piece_count; ++piece) {
    for (const Vec2& anchor : footprints[piece].anchors) {
      add_anchor_wishes(model, piece, anchor, height, bodies, hull, wishes);
    }
  }
  for (std::size_t w = 0, anchors = wishes.size(); w < anchors; ++w) {
    wishes.push_back(wishes[w]);
    wishes.back().most = bridges_of_anchor;
  }
  for (const Contact& contact : tiles.contacts) {
    if (group[contact.tile[0]] != group[contact.tile[1]]) continue;
    Wish wish{contact.tile[0], contact.tile[1], {}, 0};
    const auto a = front_edge(tiles, model.poses, contact, 0),
               b = front_edge(tiles, model.poses, contact, 1);
    const Vec2 d = (left_of(a[0] - a[1]).normalized() + left_of(b[1] - b[0]).normalized());
    for (int step = 0; step <= 16; ++step) {  // from the middle outwards, sides alternating
      const double s = 0.5 + (step % 2 ? 0.025 : -0.025) * (step + step % 2);
      const Vec2 middle = 0.5 * (a[0] + s * (a[1] - a[0]) + b[1] + s * (b[0] - b[1]));
      wish.sight.push_back({middle, d.normalized()});
    }
    wishes.push_back(std::move(wish));
  }
  Bridges bridges = make_bridges(bodies, wishes, p.H_pin, p);
  std::map<int, int> number;
  for (std::size_t k = 0; k < bridges.bodies.size(); ++k) {
    PrintBody& bridge = bridges.bodies[k];
    bridge.piece = group[bridges.joined[k][0]];
    bridge.name = numbered("Support P%d B%04d", bridge.piece + 1, ++number[bridge.piece]);
    model.supports.push_back(std::move(bridge));
  }
  find_loose(model, bridges, group);
}

// Height above the notch, where a bridge breaks.
ThinFeature notch(const Parameters& p) {
  return {"", "notch of the bridge", std::min(thickness(p) - 2 * bridge_notch, bridge_width)};
}

}  // namespace

SupportKind bridges() {
  return {"bridges", "bridges (rigid)", "break the bridges from the {second}",
          false,     add_bridges,       notch};
}

}  // namespace curveups
