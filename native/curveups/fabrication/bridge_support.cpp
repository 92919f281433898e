// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <numeric>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/fabrication/bridges.hpp"
#include "curveups/fabrication/print_parts.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups {
namespace {

// Wishes to join anchor k with its nearest tiles.
void add_anchor_wishes(const PrintModel& model, std::size_t k, std::vector<BridgeObstacle>& bodies,
                       const std::vector<Polygon>& hull, std::vector<BridgeWish>& wishes) {
  const Parameters& p = model.parameters;
  constexpr int corners = 64;
  const PrintBody& anchor = model.anchors[k];
  const Vec2 c = anchor.circles[0].centre.head<2>();
  const double r = p.anchor_radius, height = anchor.circles[1].centre.z();
  ConvexBody cylinder;
  BodyFace bottom{{}, body_tag::back, {-Vec3::UnitZ(), 0}};
  BodyFace top{{}, body_tag::front, {Vec3::UnitZ(), height}};
  for (int i = 0; i < corners; ++i) {
    const Vec2 e = PlaneRotation(6.283185307179586 * i / corners) * Vec2(r, 0);
    cylinder.points.emplace_back(c.x() + e.x(), c.y() + e.y(), 0);
    cylinder.points.emplace_back(c.x() + e.x(), c.y() + e.y(), height);
    bottom.loop.insert(bottom.loop.begin(), 2 * i);
    top.loop.push_back(2 * i + 1);
  }
  for (int i = 0; i < corners; ++i) {
    const int j = (i + 1) % corners;
    const Vec2 e = PlaneRotation(6.283185307179586 * (i + 0.5) / corners) * Vec2(1, 0);
    const Vec3 n(e.x(), e.y(), 0);
    cylinder.faces.push_back(
        {{2 * i, 2 * j, 2 * j + 1, 2 * i + 1}, body_tag::wall, {n, n.dot(cylinder.points[2 * i])}});
  }
  cylinder.faces.push_back(std::move(bottom));
  cylinder.faces.push_back(std::move(top));
  const int self = static_cast<int>(bodies.size());
  bodies.push_back({std::move(cylinder), {}, {}});
  std::vector<std::pair<double, int>> near;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (model.piece_of_tile[i] == anchor.piece) near.emplace_back(distance(hull[i], c), i);
  }
  std::sort(near.begin(), near.end());
  if (near.size() > 8) near.resize(8);
  for (const auto& [gap, tile] : near) {
    BridgeWish wish{tile, self, {}};
    Vec2 centre = Vec2::Zero();
    for (const Vec2& q : hull[tile]) centre += q / static_cast<double>(hull[tile].size());
    for (double s : {0.5, 0.3, 0.7, 0.15, 0.85}) {
      for (std::size_t e = 0; e < hull[tile].size(); ++e) {
        const Vec2 &a = hull[tile][e], &b = hull[tile][(e + 1) % hull[tile].size()];
        const Vec2 target = a + s * (b - a);
        if (wedge(b - a, c - a) >= 0 || (b - a).norm() < p.bridge_width) continue;
        const Vec2 d = (c - target).normalized();
        wish.sight.push_back({0.5 * (target + c - r * d), d});
      }
    }
    wishes.push_back(std::move(wish));
  }
}

// Two bridges hold an anchor; the rest would only have to be broken.
void keep_two_per_anchor(Bridges& bridges, int tile_count) {
  std::vector<int> held;
  Bridges kept;
  for (std::size_t k = 0; k < bridges.bodies.size(); ++k) {
    const int other = bridges.joined[k][1];
    if (other >= tile_count) {
      held.resize(std::max<std::size_t>(held.size(), other - tile_count + 1), 0);
      if (++held[other - tile_count] > 2) continue;
    }
    kept.bodies.push_back(std::move(bridges.bodies[k]));
    kept.joined.push_back(bridges.joined[k]);
  }
  bridges = std::move(kept);
}

void find_loose(PrintModel& model, const Bridges& bridges, int tile_count) {
  std::vector<int> root(tile_count + model.anchors.size());
  std::iota(root.begin(), root.end(), 0);
  auto find = [&](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& [a, b] : bridges.joined) root[find(a)] = find(b);
  std::vector<int> size(root.size(), 0), main(model.piece_count, -1);
  for (int i = 0; i < tile_count; ++i) ++size[find(i)];
  for (int i = 0; i < tile_count; ++i) {
    int& best = main[model.piece_of_tile[i]];
    if (best < 0 || size[find(i)] > size[best]) best = find(i);
  }
  for (int i = 0; i < tile_count; ++i) {
    if (find(i) != main[model.piece_of_tile[i]]) model.loose_tiles.push_back(i);
  }
  for (std::size_t k = 0; k < model.anchors.size(); ++k) {
    if (find(tile_count + static_cast<int>(k)) != main[model.anchors[k].piece]) {
      ++model.loose_anchors;
    }
  }
}

}  // namespace

void add_bridges(PrintModel& model) {
  const Parameters& p = model.parameters;
  const TileMesh& tiles = model.geometry.tiles;
  const int count = tiles.tile_count();
  std::vector<BridgeObstacle> bodies;
  std::vector<Polygon> hull;
  for (int i = 0; i < count; ++i) {
    BridgeObstacle body{moved(model.bumps.body[i], model.flat[i]), {}, {}};
    for (const WallCap& cap : model.bumps.of_tile[i]) {
      body.ball_centres.push_back(model.flat[i](cap.centre));
      body.ball_radii.push_back(cap.radius);
    }
    std::vector<Vec2> seen;
    for (const Vec3& q : body.body.points) seen.push_back(q.head<2>());
    hull.push_back(convex_hull(seen));
    bodies.push_back(std::move(body));
  }
  std::vector<BridgeWish> wishes;
  for (const Contact& contact : tiles.contacts) {
    BridgeWish wish{contact.tile[0], contact.tile[1], {}};
    const auto a = front_edge(model, contact, 0), b = front_edge(model, contact, 1);
    const Vec2 d = (left_of(a[0] - a[1]).normalized() + left_of(b[1] - b[0]).normalized());
    for (int step = 0; step <= 16; ++step) {  // from the middle outwards, to both sides in turn
      const double s = 0.5 + (step % 2 ? 0.025 : -0.025) * (step + step % 2);
      const Vec2 middle = 0.5 * (a[0] + s * (a[1] - a[0]) + b[1] + s * (b[0] - b[1]));
      wish.sight.push_back({middle, d.normalized()});
    }
    wishes.push_back(std::move(wish));
  }
  for (std::size_t k = 0; k < model.anchors.size(); ++k) {
    add_anchor_wishes(model, k, bodies, hull, wishes);
  }
  Bridges bridges = make_bridges(bodies, wishes, p.H_pin, p);
  keep_two_per_anchor(bridges, count);
  std::vector<int> number(model.piece_count, 0);
  for (std::size_t k = 0; k < bridges.bodies.size(); ++k) {
    PrintBody& bridge = bridges.bodies[k];
    bridge.piece = model.piece_of_tile[bridges.joined[k][0]];
    bridge.name = numbered("Support P%d B%04d", bridge.piece + 1, ++number[bridge.piece]);
    model.supports.push_back(std::move(bridge));
  }
  find_loose(model, bridges, count);
}

}  // namespace curveups
