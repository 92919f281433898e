// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/anchors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"

namespace curveups {
namespace {

constexpr double contour_deviation = 0.1;  // how far the contour may lie inside, mm
constexpr double anchor_gap = 0.5;         // between two anchors, mm

// Points along the closed contour at equal distances of about `spacing`, from its lowest point on.
std::vector<Vec2> spread_along(const Polygon& loop, double spacing) {
  const std::size_t n = loop.size();
  std::size_t start = 0;
  double length = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (loop[k].y() < loop[start].y()) start = k;
    length += (loop[(k + 1) % n] - loop[k]).norm();
  }
  const int count = std::max(1, static_cast<int>(std::floor(length / spacing)));
  std::vector<Vec2> points;
  double walked = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 &a = loop[(start + k) % n], &b = loop[(start + k + 1) % n];
    const double side = (b - a).norm();
    while (static_cast<int>(points.size()) < count) {
      const double target = points.size() * length / count;
      if (target > walked + side) break;
      points.push_back(a + (side > 0 ? (target - walked) / side : 0) * (b - a));
    }
    walked += side;
  }
  return points;
}

}  // namespace

std::array<Vec2, 2> front_edge(const TileMesh& tiles, const FlatPoses& poses,
                               const Contact& contact, int side) {
  const int tile = contact.tile[side], wall = contact.side[side];
  const std::array<Vec2, 3> corner = place(poses, tile, tiles.front[tile]);
  return {corner[wall], corner[next3(wall)]};
}

void join_footprints(std::vector<PieceFootprint>& pieces, const std::vector<int>& piece_of_tile,
                     const TileMesh& tiles, const FlatPoses& poses) {
  for (const Contact& contact : tiles.contacts) {
    const auto a = front_edge(tiles, poses, contact, 0), b = front_edge(tiles, poses, contact, 1);
    const Polygon hull = convex_hull({a[0], a[1], b[0], b[1]});
    if (hull.size() >= 3) {
      PieceFootprint& piece = pieces[piece_of_tile[contact.tile[0]]];
      piece.joints.push_back(hull);
      piece.joined.push_back({contact.tile[0], contact.tile[1]});
    }
  }
}

std::vector<std::vector<Vec2>> place_anchors(const std::vector<PieceFootprint>& pieces,
                                             const Parameters& p) {
  const double reach = anchor_distance + p.anchor_radius;
  const double least = 2 * p.anchor_radius + anchor_gap;
  std::vector<std::vector<Vec2>> candidates(pieces.size()), anchors(pieces.size());
  parallel_for(static_cast<int>(pieces.size()), [&](int i) {
    std::vector<OutlineShape> shapes;
    for (const Polygon& tile : pieces[i].tiles) {
      shapes.push_back({tile, reach + contour_deviation});
    }
    for (const Polygon& joint : pieces[i].joints) {
      shapes.push_back({joint, reach + contour_deviation});
    }
    const Polygon contour = outline_of(shapes, contour_deviation)[0];
    candidates[i] = spread_along(contour, std::max(anchor_spacing, least));
  });
  std::vector<Vec2> all;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const Vec2& c : candidates[i]) {
      bool free = true;
      for (const Vec2& other : all) free = free && (other - c).norm() >= least;
      for (const PieceFootprint& piece : pieces) {
        for (const Polygon& tile : piece.tiles) {
          if (!free) break;
          free = distance(tile, c) >= reach - 1e-3;
        }
      }
      if (!free) continue;
      all.push_back(c);
      anchors[i].push_back(c);
    }
  }
  return anchors;
}

int nearest_tile(const PieceFootprint& footprint, const Vec2& place) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < footprint.tiles.size(); ++k) {
    for (const Vec2& corner : footprint.tiles[k]) {
      const double distance = (corner - place).norm();
      if (distance < least) nearest = footprint.rows[k], least = distance;
    }
  }
  return nearest;
}

PrintBody make_anchor(const Vec2& centre, double radius, double height) {
  PrintBody body;
  body.kind = BodyKind::anchor;
  for (double z : {0.0, height}) {
    body.circles.push_back({Vec3(centre.x(), centre.y(), z), Vec3::UnitZ(), radius});
    PlanarFace face;
    face.normal = z > 0 ? Vec3(Vec3::UnitZ()) : Vec3(-Vec3::UnitZ());
    face.outer.circle = static_cast<int>(body.circles.size()) - 1;
    body.faces.push_back(std::move(face));
  }
  body.cylinders.push_back({0, 1, true});
  return body;
}

}  // namespace curveups
