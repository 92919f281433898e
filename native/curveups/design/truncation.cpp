// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/truncation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

// A tile at one of its front vertices, which is the origin, in world directions.
struct Cone {
  int tile, corner;
  std::array<Vec3, 2> wall;  // outward normals of edge `corner` and of the one before it
  Vec3 lid;                  // normal of the front face, away from the cone
  std::array<Vec3, 2> edge;  // unit directions of the two front edges
  Vec3 spine;                // unit direction of the edge in which the two walls meet
  Vec3 middle;               // unit direction to the front face's centroid

  bool contains(const Vec3& ray, double slack) const {
    return wall[0].dot(ray) <= slack && wall[1].dot(ray) <= slack && lid.dot(ray) <= slack;
  }
};

Cone back_cone(const TileMesh& tiles, int tile, int corner) {
  const RigidMotion& frame = tiles.frame[tile];
  auto world = [&](const Vec3& d) -> Vec3 { return frame.R * d; };
  auto flat = [&](const Vec2& d) { return world(Vec3(d.x(), d.y(), 0)); };
  const std::array<Vec2, 3>& front = tiles.front[tile];
  Cone cone;
  cone.tile = tile;
  cone.corner = corner;
  cone.wall = {world(tiles.wall_normal(tile, corner)),
               world(tiles.wall_normal(tile, prev3(corner)))};
  cone.lid = tiles.normal(tile);
  cone.edge = {flat((front[next3(corner)] - front[corner]).normalized()),
               flat((front[prev3(corner)] - front[corner]).normalized())};
  cone.spine = cone.wall[0].cross(cone.wall[1]).normalized();
  if (cone.spine.dot(cone.lid) > 0) cone.spine = -cone.spine;
  cone.middle = (flat((front[0] + front[1] + front[2]) / 3 - front[corner])).normalized();
  return cone;
}

// The cone above the front face instead.
void turn_to_front(Cone& cone) {
  cone.lid = -cone.lid;
  cone.spine = -cone.spine;
}

struct Crossing {
  Vec3 ray;
  int wall_a, wall_b;
};

// Plane through the origin that separates two cones. type 0: they do not overlap; -1: no plane.
struct Split {
  int type = 0;
  Vec3 normal = Vec3::Zero();  // from a to b
};

// Plane through a ray of the overlap and perpendicular to the way from one tile to the other. It
// takes away more than the plane through two crossing rays, but leaves the front faces alone where
// these rays nearly coincide (tiles that nearly touch in a line, as around regular vertices).
Split separate_along(const Cone& a, const Cone& b, const Vec3& ray, double slack) {
  const Vec3 way = b.middle - a.middle;
  const Vec3 normal = (way - way.dot(ray) * ray).normalized();
  const bool apart = normal.dot(b.middle) > 0 && normal.dot(a.middle) < 0;
  const bool fronts_kept = std::max(normal.dot(a.edge[0]), normal.dot(a.edge[1])) <= slack &&
                           std::min(normal.dot(b.edge[0]), normal.dot(b.edge[1])) >= -slack;
  return apart && fronts_kept ? Split{2, normal} : Split{-1, Vec3::Zero()};
}

Split separate(const Cone& a, const Cone& b, double slack) {
  std::vector<Crossing> crossings;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      Vec3 ray = a.wall[i].cross(b.wall[j]);
      const double sine = ray.norm();
      if (sine < 1e-12) continue;
      ray /= sine;
      for (double sign : {1.0, -1.0}) {
        if (a.contains(sign * ray, slack) && b.contains(sign * ray, slack)) {
          crossings.push_back({sign * ray, i, j});
        }
      }
    }
  }
  if (crossings.size() < 2) {
    // Folded over: a tile lies inside the other, or is pierced through its front face.
    for (const Cone* inner : {&a, &b}) {
      const Cone& outer = inner == &a ? b : a;
      for (const Vec3& ray : {inner->spine, inner->edge[0], inner->edge[1]}) {
        if (outer.contains(ray, -slack)) return separate_along(a, b, inner->spine, slack);
      }
    }
    return {};
  }
  // Two rays span the plane; a third lies next to one of them. Of four, either diagonal pair does.
  double widest = 0;
  for (const Crossing& p : crossings) {
    for (const Crossing& q : crossings) widest = std::max(widest, p.ray.cross(q.ray).norm());
  }
  if (widest < slack) return {};  // tiles only touch in a ray
  Split best{-1};
  double best_margin = 0;
  for (std::size_t m = 0; m < crossings.size(); ++m) {
    for (std::size_t n = m + 1; n < crossings.size(); ++n) {
      const Crossing &p = crossings[m], &q = crossings[n];
      const bool diagonal = p.wall_a != q.wall_a && p.wall_b != q.wall_b;
      Vec3 normal = p.ray.cross(q.ray);
      const double sine = normal.norm();
      if (crossings.size() == 4 ? !diagonal : sine < 0.5 * widest) continue;
      normal /= sine;
      if (normal.dot(b.middle) < 0) normal = -normal;
      const double margin = std::min(normal.dot(b.middle), -normal.dot(a.middle));
      const bool fronts_kept = std::max(normal.dot(a.edge[0]), normal.dot(a.edge[1])) <= slack &&
                               std::min(normal.dot(b.edge[0]), normal.dot(b.edge[1])) >= -slack;
      if (margin <= best_margin || !fronts_kept) continue;
      best_margin = margin;
      best.normal = normal;
      best.type = crossings.size() == 4 ? 3 : diagonal ? 2 : 1;
    }
  }
  if (best.type >= 0) return best;
  Vec3 middle = Vec3::Zero();
  for (const Crossing& crossing : crossings) middle += crossing.ray;
  return separate_along(a, b, middle.normalized(), slack);
}

Plane plane_in_frame(const TileMesh& tiles, const Cone& cone, const Vec3& normal) {
  const Vec3 local = tiles.frame[cone.tile].R.transpose() * normal;
  return {local, local.head<2>().dot(tiles.front[cone.tile][cone.corner])};
}

// Planes for the tiles at one vertex, on one side of their front faces.
void truncate_at(int vertex, const TileMesh& tiles, const std::vector<Cone>& cones, Side side,
                 Truncation& out) {
  auto& planes = side == Side::front ? out.front_pins : out.of_tile;
  // Rays within this angle of a plane are less than a snap away from it at the back.
  const double slack = tolerance::snap / tiles.H_body;
  for (std::size_t m = 0; m < cones.size(); ++m) {
    for (std::size_t n = m + 1; n < cones.size(); ++n) {
      const Cone &a = cones[m], &b = cones[n];
      if ((tiles.topology.neighbour.row(a.tile).array() == b.tile).any()) continue;
      const Split split = separate(a, b, slack);
      if (split.type == 0) continue;
      if (split.type < 0) {
        if (side == Side::back) out.unresolved.push_back({a.tile, b.tile});
        continue;
      }
      if (side == Side::back) ++out.pairs_of_type[split.type];
      planes[a.tile].push_back(
          {plane_in_frame(tiles, a, split.normal), b.tile, vertex, split.type});
      planes[b.tile].push_back(
          {plane_in_frame(tiles, b, -split.normal), a.tile, vertex, split.type});
    }
  }
}

}  // namespace

void truncate_at_vertices(const TileMesh& tiles, const std::vector<int>& vertices,
                          Truncation& truncation) {
  // Corners by vertex, in the order of the tiles.
  std::vector<int> index(tiles.mesh.V.rows(), -1);
  for (std::size_t k = 0; k < vertices.size(); ++k) index[vertices[k]] = static_cast<int>(k);
  std::vector<std::vector<std::array<int, 2>>> corners(vertices.size());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) {
      const int k = index[tiles.mesh.F(i, t)];
      if (k >= 0) corners[k].push_back({i, t});
    }
  }
  std::vector<Cone> cones;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (corners[k].size() < 3) continue;
    cones.clear();
    for (const auto& [tile, corner] : corners[k]) cones.push_back(back_cone(tiles, tile, corner));
    truncate_at(vertices[k], tiles, cones, Side::back, truncation);
    for (Cone& cone : cones) turn_to_front(cone);
    truncate_at(vertices[k], tiles, cones, Side::front, truncation);
  }
}

Truncation truncate_at_vertices(const TileMesh& tiles) {
  Truncation out;
  out.of_tile.resize(tiles.tile_count());
  out.front_pins.resize(tiles.tile_count());
  std::vector<int> all(tiles.mesh.V.rows());
  std::iota(all.begin(), all.end(), 0);
  truncate_at_vertices(tiles, all, out);
  return out;
}

ConvexBody tile_body(const TileMesh& tiles, const Truncation& truncation, int tile,
                     const std::array<double, 3>& recess) {
  std::array<double, 3> at_front, at_back;
  for (int t = 0; t < 3; ++t) {
    at_front[t] = recess[t] / std::cos(0.5 * tiles.dihedral(tile, t));
    at_back[t] = at_front[t] + tiles.back_shift(tile, t);
  }
  ConvexBody body = make_frustum(inset_triangle(tiles.front[tile], at_front), 0,
                                 inset_triangle(tiles.front[tile], at_back), -tiles.H_body);
  int tag = body_tag::cut;
  for (const TruncationPlane& t : truncation.of_tile[tile]) {
    clip(body, t.plane, tag++);
    if (body.faces.empty()) break;
  }
  return body;
}

}  // namespace curveups
