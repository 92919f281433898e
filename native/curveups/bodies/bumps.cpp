// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/bumps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "curveups/bodies/bump_pattern.hpp"
#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {
namespace {

constexpr double edge_margin = 0.1;      // between a cap and the rim of its wall, mm
constexpr double bump_spacing = 0.2;     // between two caps of an interface, mm
constexpr double flat_clearance = 0.05;  // between a cap and the neighbour in the flat layout, mm
constexpr double hollow_margin = 0.2;    // of material beside a hollow at least, mm
constexpr int shrink_steps = 4;          // of the diameter
constexpr double least_diameter = 0.5;   // smallest share of the diameter: half a sphere

const BodyFace* find_face(const ConvexBody& body, int tag) {
  for (const BodyFace& face : body.faces) {
    if (face.tag == tag) return &face;
  }
  return nullptr;
}

// The plane of an interface: u along the front edge, n from tile[0] to tile[1].
struct InterfacePlane {
  Vec3 origin, u, v, n;
  Vec2 to_plane(const Vec3& p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
  Vec3 to_world(const Vec2& p) const { return origin + p.x() * u + p.y() * v; }
};

InterfacePlane make_plane(const ContactPatch& patch) {
  InterfacePlane plane;
  plane.origin = patch.point[0];
  plane.n = patch.normal;
  plane.u = (patch.point[1] - patch.point[0]).normalized();
  plane.v = plane.n.cross(plane.u);
  return plane;
}

struct Shape {
  double radius, height;
};

Shape dimple_of(const Shape& bump) {
  const double R = sphere_radius(bump.radius, bump.height);
  const double flat = R - bump.height;
  const double wider = R + dimple_clearance;
  return {std::sqrt(wider * wider - flat * flat), bump.height + dimple_clearance};
}

class Planner {
 public:
  Planner(const DesignGeometry& geometry, const FlatPoses& poses, const Parameters& parameters)
      : geometry_(geometry),
        tiles_(geometry.tiles),
        poses_(poses),
        p_(parameters),
        material_(std::max(parameters.p_floor, hollow_margin)) {}

  BumpPlan run() {
    const int count = static_cast<int>(tiles_.contacts.size());
    plan_.recess = Array3::Zero(tiles_.tile_count(), 3);
    for (const Contact& contact : tiles_.contacts) set_recess(contact, wall_recess(p_));
    build_bodies();
    if (p_.bumps == "none") return finish();
    centres_.resize(count);
    shape_.resize(count);
    shrink_.assign(count, 0);
    reason_.assign(count, "");
    parallel_for(count, [&](int k) { place(k); });
    parallel_for(count, [&](int k) { check_flat(k); });
    if (p_.bumps == "dimples") fit_hollows();
    for (int k = 0; k < count; ++k) {
      if (reason_[k].empty()) continue;
      plan_.bare.push_back({k, reason_[k]});
      set_recess(tiles_.contacts[k], std::min(wall_recess(p_), p_.xy_compensation));
    }
    if (!plan_.bare.empty()) build_bodies();
    return finish();
  }

 private:
  void set_recess(const Contact& contact, double value) {
    for (int s = 0; s < 2; ++s) plan_.recess(contact.tile[s], contact.side[s]) = value;
  }

  void build_bodies() {
    const int count = tiles_.tile_count();
    plan_.body.resize(count);
    std::vector<char> broken(count, 0);
    parallel_for(count, [&](int i) {
      const auto r = plan_.recess.row(i);
      plan_.body[i] = tile_body(tiles_, geometry_.truncation, i, {r[0], r[1], r[2]});
      broken[i] =
          !find_face(plan_.body[i], body_tag::front) || !find_face(plan_.body[i], body_tag::back);
    });
    std::vector<int> lost;
    for (int i = 0; i < count; ++i) {
      if (broken[i]) lost.push_back(i);
    }
    if (!lost.empty()) {
      throw InfeasibleDesign("the front or back face of " + std::to_string(lost.size()) +
                                 " tiles vanishes or turns inside out",
                             "lower H_body or bump_height, or flatten the folds there", lost);
    }
  }

  // Room for the centres of bumps of this shape, in the interface's plane.
  Polygon region(int k, const InterfacePlane& plane, const Shape& bump) const {
    const bool dimples = p_.bumps == "dimples";
    const Shape hollow = dimple_of(bump);
    const double radius = dimples ? hollow.radius : bump.radius;
    const Contact& contact = tiles_.contacts[k];
    std::vector<Vec2> corners;
    for (const Vec3& p : geometry_.patches[k].polygon) corners.push_back(plane.to_plane(p));
    Polygon common = convex_hull(corners);
    for (int s = 0; s < 2; ++s) {
      const int tile = contact.tile[s];
      const BodyFace* wall = find_face(plan_.body[tile], body_tag::wall + contact.side[s]);
      if (!wall) return {};
      corners.clear();
      for (int i : wall->loop) {
        corners.push_back(plane.to_plane(tiles_.frame[tile](plan_.body[tile].points[i])));
      }
      common = intersection(common, convex_hull(corners));
    }
    common = inset(common, radius + edge_margin);
    if (dimples) common = region_for_hollows(k, plane, hollow, std::move(common));
    return common;
  }

  // Part of the region in which hollows in either wall keep their distance from the other faces of
  // their tile, and from hollows of the next wall at the same distance from the corner.
  Polygon region_for_hollows(int k, const InterfacePlane& plane, const Shape& hollow,
                             Polygon region) const {
    const double R = sphere_radius(hollow.radius, hollow.height), flat = R - hollow.height;
    const Contact& contact = tiles_.contacts[k];
    const double length = (geometry_.patches[k].point[1] - plane.origin).norm();
    for (int s = 0; s < 2; ++s) {
      const int tile = contact.tile[s], wall = contact.side[s];
      const RigidMotion& frame = tiles_.frame[tile];
      const Vec3 inward = -tiles_.wall_normal(tile, wall), start = frame.to_own(plane.origin);
      const Vec3 u = frame.to_own(plane.origin + plane.u) - start;
      const Vec3 v = frame.to_own(plane.origin + plane.v) - start;
      const Vec3 origin = start + plan_.recess(tile, wall) * inward;
      for (const BodyFace& face : plan_.body[tile].faces) {
        if (face.tag == body_tag::wall + wall) continue;
        // The hollow's point nearest to the face lies on its sphere, or else on its rim.
        const Vec3& n = face.plane.normal;
        const double slope = inward.dot(n);
        const double depth = slope * R >= flat
                                 ? face.plane.distance(origin - flat * inward) + R + material_
                                 : face.plane.distance(origin) +
                                       hollow.radius * std::sqrt(std::max(0.0, 1 - slope * slope)) +
                                       material_;
        region = clip(region, Vec2(n.dot(u), n.dot(v)), -depth);
      }
      for (int end = 0; end < 2; ++end) {
        const double sine = std::sin(0.5 * corner_angle(tile, end ? next3(wall) : wall));
        const double keep = (hollow.radius + 0.5 * material_) / sine;
        // Tile 0 runs along u from the origin, tile 1 the other way.
        const bool at_origin = (end == 0) == (s == 0);
        region = at_origin ? clip(region, -Vec2::UnitX(), -keep)
                           : clip(region, Vec2::UnitX(), length - keep);
      }
    }
    return region;
  }

  double corner_angle(int tile, int corner) const {
    const std::array<Vec2, 3>& c = tiles_.front[tile];
    const Vec2 a = c[next3(corner)] - c[corner], b = c[next3(next3(corner))] - c[corner];
    return std::atan2(std::abs(wedge(a, b)), a.dot(b));
  }

  // Places bumps of the largest diameter that fits, from shrink_[k] steps below the standard one.
  void place(int k) {
    centres_[k].clear();
    if (geometry_.patches[k].point_count < 3) {
      reason_[k] = "edge_only";
      return;
    }
    const InterfacePlane plane = make_plane(geometry_.patches[k]);
    for (int& step = shrink_[k]; step <= shrink_steps; ++step) {
      const double shrunk = 1 - (1 - least_diameter) * step / shrink_steps;
      shape_[k] = {0.5 * bump_aspect * p_.bump_height * shrunk, p_.bump_height};
      const double apart = p_.bumps == "dimples" ? 2 * dimple_of(shape_[k]).radius + material_
                                                 : 2 * shape_[k].radius + bump_spacing;
      for (const Vec2& p : bump_pattern(region(k, plane, shape_[k]), apart)) {
        centres_[k].push_back(plane.to_world(p));
      }
      if (!centres_[k].empty()) return;
    }
    reason_[k] = "too_small";
  }

  // The caps of one side of an interface in that tile's frame; bumps alternate along the edge.
  std::vector<WallCap> caps_of(int k, int s) const {
    const Contact& contact = tiles_.contacts[k];
    const int tile = contact.tile[s], wall = contact.side[s];
    const Vec3 normal = tiles_.wall_normal(tile, wall);
    const Shape hollow = dimple_of(shape_[k]);
    std::vector<WallCap> caps;
    for (std::size_t i = 0; i < centres_[k].size(); ++i) {
      const bool own = static_cast<int>(i % 2) == s;
      if (!own && p_.bumps != "dimples") continue;
      const Shape shape = own ? shape_[k] : hollow;
      const Vec3 centre =
          tiles_.frame[tile].to_own(centres_[k][i]) - plan_.recess(tile, wall) * normal;
      caps.push_back(
          {wall, centre, own ? normal : Vec3(-normal), shape.radius, shape.height, own, k});
    }
    return caps;
  }

  void check_flat(int k) {
    if (!reason_[k].empty()) return;
    const Contact& contact = tiles_.contacts[k];
    std::array<std::vector<CapSphere>, 2> spheres;
    for (int s = 0; s < 2; ++s) {
      const RigidMotion motion = flat_motion(poses_, contact.tile[s], 0);
      for (const WallCap& cap : caps_of(k, s)) {
        if (!cap.bump) continue;
        spheres[s].push_back(
            cap_sphere(motion(cap.centre), motion.R * cap.axis, cap.radius, cap.height));
      }
    }
    double least = 1e300;
    for (int s = 0; s < 2; ++s) {
      const int other = contact.tile[1 - s];
      const ConvexBody body = moved(plan_.body[other], flat_motion(poses_, other, 0));
      for (const CapSphere& a : spheres[s]) {
        least = std::min(least, distance(a, body));
        for (const CapSphere& b : spheres[1 - s]) least = std::min(least, distance(a, b));
      }
    }
    if (least < flat_clearance) reason_[k] = "would_touch";
  }

  // True if the hollows of an interface keep their distance from faces and `placed` hollows.
  bool hollows_fit(int k, const std::vector<std::vector<WallCap>>& placed) const {
    for (int s = 0; s < 2; ++s) {
      const int tile = tiles_.contacts[k].tile[s];
      for (const WallCap& cap : caps_of(k, s)) {
        if (cap.bump) continue;
        const CapSphere sphere = cap_sphere(cap.centre, cap.axis, cap.radius, cap.height);
        for (const BodyFace& face : plan_.body[tile].faces) {
          if (face.tag == body_tag::wall + cap.wall) continue;
          const Vec3 deepest = sphere.centre + sphere.radius * face.plane.normal;
          if (sphere.on_cap(face.plane.normal) &&
              face.plane.distance(deepest) > -material_ + 1e-9) {
            return false;
          }
        }
        for (const WallCap& other : placed[tile]) {
          // Infinite where the spheres are nearest beyond the caps: then base discs are nearer.
          const double apart =
              distance(sphere, cap_sphere(other.centre, other.axis, other.radius, other.height));
          const double discs = (other.centre - cap.centre).norm() - other.radius - cap.radius;
          if ((std::isfinite(apart) ? apart : discs) < material_) return false;
        }
      }
    }
    return true;
  }

  // Shrinks hollows, interface after interface, that do not fit beside those placed before.
  void fit_hollows() {
    std::vector<std::vector<WallCap>> placed(tiles_.tile_count());
    for (int k = 0; k < static_cast<int>(tiles_.contacts.size()); ++k) {
      bool fits = reason_[k].empty() && hollows_fit(k, placed);
      while (!fits && reason_[k].empty()) {
        if (++shrink_[k] > shrink_steps) {
          reason_[k] = "would_break_through";
          break;
        }
        place(k);
        if (reason_[k].empty()) check_flat(k);
        fits = reason_[k].empty() && hollows_fit(k, placed);
      }
      if (!fits) continue;
      for (int s = 0; s < 2; ++s) {
        for (const WallCap& cap : caps_of(k, s)) {
          if (!cap.bump) placed[tiles_.contacts[k].tile[s]].push_back(cap);
        }
      }
    }
  }

  BumpPlan finish() {
    plan_.of_tile.resize(tiles_.tile_count());
    for (std::size_t k = 0; k < centres_.size(); ++k) {
      if (!reason_[k].empty()) continue;
      for (int s = 0; s < 2; ++s) {
        std::vector<WallCap>& caps = plan_.of_tile[tiles_.contacts[k].tile[s]];
        for (const WallCap& cap : caps_of(static_cast<int>(k), s)) caps.push_back(cap);
      }
    }
    return std::move(plan_);
  }

  const DesignGeometry& geometry_;
  const TileMesh& tiles_;
  const FlatPoses& poses_;
  const Parameters& p_;
  const double material_;  // to be left beside a hollow, mm
  BumpPlan plan_;
  std::vector<std::vector<Vec3>> centres_;  // per contact, in the unrecessed interface plane
  std::vector<Shape> shape_;
  std::vector<int> shrink_;
  std::vector<std::string> reason_;
};

}  // namespace

BumpPlan plan_bumps(const DesignGeometry& geometry, const FlatPoses& poses,
                    const Parameters& parameters) {
  return Planner(geometry, poses, parameters).run();
}

double sliding_play(const BumpPlan& plan, const TileMesh& tiles) {
  // Radius of bumps and of hollows per contact.
  std::vector<std::array<double, 2>> radius(tiles.contacts.size(), {0, 0});
  for (const std::vector<WallCap>& caps : plan.of_tile) {
    for (const WallCap& cap : caps) radius[cap.contact][cap.bump ? 0 : 1] = cap.radius;
  }
  double play = 0;
  for (const auto& [bump, hollow] : radius) play = std::max(play, hollow - bump);
  return play;
}

std::vector<Points3> bump_tips(const BumpPlan& plan, const TileMesh& tiles) {
  std::vector<std::vector<Vec3>> of_contact(tiles.contacts.size());
  std::vector<char> hollowed(tiles.contacts.size(), 0);
  for (const std::vector<WallCap>& caps : plan.of_tile) {
    for (const WallCap& cap : caps) hollowed[cap.contact] |= !cap.bump;
  }
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (const WallCap& cap : plan.of_tile[i]) {
      if (hollowed[cap.contact]) continue;
      of_contact[cap.contact].push_back(tiles.frame[i](cap.centre + cap.height * cap.axis));
    }
  }
  std::vector<Points3> tips;
  for (const std::vector<Vec3>& apexes : of_contact) {
    Points3 rows(apexes.size(), 3);
    for (std::size_t k = 0; k < apexes.size(); ++k) rows.row(k) = apexes[k].transpose();
    tips.push_back(std::move(rows));
  }
  return tips;
}

}  // namespace curveups
