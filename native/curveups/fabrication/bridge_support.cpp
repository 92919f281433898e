// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/disjoint_sets.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/bridges.hpp"
#include "curveups/fabrication/print_parts.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups {
namespace {

constexpr int bridges_of_anchor = 2;  // they hold it; more would only have to be broken

// Wishes to join the anchor at c, which becomes one of the bodies, with its piece's nearest tiles.
void add_anchor_wishes(const PrintModel& model, int piece, const Vec2& c, double height,
                       std::vector<BridgeObstacle>& bodies, const std::vector<Polygon>& hull,
                       std::vector<BridgeWish>& wishes) {
  const Parameters& p = model.parameters;
  constexpr int corners = 64;
  const double r = p.anchor_radius;
  Polygon circle;
  for (int i = 0; i < corners; ++i) {
    circle.push_back(c + PlaneRotation(2 * M_PI * i / corners) * Vec2(r, 0));
  }
  const int self = static_cast<int>(bodies.size());
  bodies.push_back({make_prism(circle, 0, height), {}, {}});
  std::vector<std::pair<double, int>> near;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (model.piece_of_tile[i] == piece) near.emplace_back(distance(hull[i], c), i);
  }
  std::sort(near.begin(), near.end());
  if (near.size() > 8) near.resize(8);
  const std::vector<int>& part = model.division.part_of_tile;
  for (const auto& [gap, tile] : near) {
    if (!part.empty() && part[tile] != part[near.front().second]) continue;
    BridgeWish wish{tile, self, {}, 1};
    std::vector<std::array<Vec2, 2>> beside;
    for (double s : {0.5, 0.3, 0.7, 0.15, 0.85}) {
      for (std::size_t e = 0; e < hull[tile].size(); ++e) {
        const Vec2 &a = hull[tile][e], &b = hull[tile][(e + 1) % hull[tile].size()];
        const Vec2 target = a + s * (b - a);
        if (wedge(b - a, c - a) >= 0 || (b - a).norm() < bridge_width) continue;
        // Towards the axis, or straight out of the wall, where the anchor is met beside its axis.
        const Vec2 inwards = (c - target).normalized(), out = -left_of(b - a).normalized();
        wish.sight.push_back({0.5 * (target + c - r * inwards), inwards});
        beside.push_back({target + 0.5 * anchor_distance * out, out});
      }
    }
    wish.sight.insert(wish.sight.end(), beside.begin(), beside.end());
    wishes.push_back(std::move(wish));
  }
}

// group: of each tile its piece, or its part of that.
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
  // Anchors first: they have fewer places to choose from.
  const double height = 2 * p.H_pin + p.H_body;
  for (int piece = 0; piece < model.piece_count; ++piece) {
    for (const Vec2& anchor : footprints[piece].anchors) {
      add_anchor_wishes(model, piece, anchor, height, bodies, hull, wishes);
    }
  }
  const std::size_t first = wishes.size();  // each anchor has one before any has its second
  for (std::size_t w = 0; w < first; ++w) {
    wishes.push_back(wishes[w]);
    wishes.back().enough = bridges_of_anchor;
  }
  for (const Contact& contact : tiles.contacts) {
    if (group[contact.tile[0]] != group[contact.tile[1]]) continue;
    BridgeWish wish{contact.tile[0], contact.tile[1], {}, 0};
    const auto a = front_edge(tiles, model.poses, contact, 0),
               b = front_edge(tiles, model.poses, contact, 1);
    const Vec2 d = (left_of(a[0] - a[1]).normalized() + left_of(b[1] - b[0]).normalized());
    for (int step = 0; step <= 16; ++step) {  // from the middle outwards, to both sides in turn
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

ThinFeature notch(const Parameters& p) {
  return {"", "notch of the bridge", std::min(bridge_neck(p), bridge_width)};
}

}  // namespace

// Bridges are broken, not dissolved: they may well be of the tiles' own material.
SupportKind bridges() {
  return {"bridges", "bridges (rigid)", "break the bridges from the {second}",
          false,     add_bridges,       notch};
}

}  // namespace curveups
