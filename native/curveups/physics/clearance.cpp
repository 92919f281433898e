// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/clearance.hpp"

#include <algorithm>
#include <limits>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// mm. Bodies that touch have edges in common: of those as near as this the last is taken, so that
// the choice does not depend on last digits.
constexpr double as_near = 1e-9;

void take_nearer(double distance, int tile, MembraneClearance& best) {
  if (distance < best.distance + as_near) best = {std::min(distance, best.distance), tile};
}

struct NearTriangle {
  std::array<Vec3, 3> corner;  // in the tile's frame
  double bound;                // distance or minus depth at least; below 0 where they may overlap
};

// Signed distance of the lowest corner to a face's plane.
double height(const BodyFace& face, const std::array<Vec3, 3>& corner) {
  return std::min({face.plane.distance(corner[0]), face.plane.distance(corner[1]),
                   face.plane.distance(corner[2])});
}

// Distance of a face's plane that has the triangle outside; where there is none, minus the depth of
// the lowest corner below `front`.
double least_distance(const ConvexBody& body, const BodyFace& front,
                      const std::array<Vec3, 3>& corner) {
  double outside = 0;
  for (const BodyFace& face : body.faces) outside = std::max(outside, height(face, corner));
  return outside > 0 ? outside : std::min(0.0, height(front, corner));
}

ConvexBody flat_body(const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  const double offset = normal.dot(t[0]);
  return {{t.begin(), t.end()},
          {{{0, 1, 2}, body_tag::front, {normal, offset}},
           {{0, 2, 1}, body_tag::back, {-normal, -offset}}}};
}

// Largest depth below the face of the part of a triangle within the body's walls.
double depth_in_body(ConvexBody triangle, const ConvexBody& body, const BodyFace& face) {
  for (const BodyFace& wall : body.faces) {
    if (wall.tag != face.tag) clip(triangle, wall.plane, body_tag::cut);
  }
  double depth = 0;
  for (const Vec3& p : triangle.points) depth = std::max(depth, -face.plane.distance(p));
  return depth;
}

}  // namespace

std::vector<MembraneClearance> patch_clearances(const DesignGeometry& geometry,
                                                const MembraneSolution& membrane, double H_pin) {
  const TileMesh& tiles = geometry.tiles;
  const bool front = membrane.domain.side == Side::front;
  const int tag = front ? body_tag::front : body_tag::back;
  const std::vector<MembranePatch>& patches = membrane.domain.patches;
  const SolvedMembrane& m = membrane.fine;
  std::vector<std::vector<std::size_t>> triangles(patches.size());
  for (std::size_t t = 0; t < m.mesh.patch.size(); ++t) triangles[m.mesh.patch[t]].push_back(t);
  std::vector<ConvexBody> bodies(tiles.tile_count());
  parallel_for(tiles.tile_count(),
               [&](int i) { bodies[i] = tile_body(tiles, geometry.truncation, i); });
  std::vector<MembraneClearance> of_patch(patches.size());
  parallel_for(static_cast<int>(patches.size()), [&](int p) {
    MembraneClearance& best = of_patch[p];
    best.distance = H_pin;
    for (int tile : tiles_of(patches[p])) {
      const ConvexBody& body = bodies[tile];
      const auto face = std::find_if(body.faces.begin(), body.faces.end(),
                                     [&](const BodyFace& f) { return f.tag == tag; });
      if (face == body.faces.end()) continue;
      std::vector<NearTriangle> near;
      for (std::size_t t : triangles[p]) {
        std::array<Vec3, 3> corner;
        for (int c = 0; c < 3; ++c) {
          corner[c] = tiles.frame[tile].to_own(m.state.x.row(m.mesh.triangles[t][c]).transpose());
        }
        const double bound = least_distance(body, *face, corner);
        if (bound < best.distance + as_near) near.push_back({corner, bound});
      }
      std::sort(near.begin(), near.end(),
                [](const NearTriangle& a, const NearTriangle& b) { return a.bound < b.bound; });
      for (const NearTriangle& next : near) {
        if (next.bound >= best.distance + as_near) break;
        const ConvexBody triangle = flat_body(next.corner);
        const double depth = next.bound < 0 ? depth_in_body(triangle, body, *face) : 0;
        take_nearer(depth > 0 ? -depth : distance(body, triangle), tile, best);
      }
    }
  });
  return of_patch;
}

MembraneClearance least_clearance(const std::vector<MembraneClearance>& of_patches, double H_pin) {
  MembraneClearance best{H_pin, -1};
  for (const MembraneClearance& of_patch : of_patches) {
    if (of_patch.tile >= 0) take_nearer(of_patch.distance, of_patch.tile, best);
  }
  return best;
}

}  // namespace curveups
