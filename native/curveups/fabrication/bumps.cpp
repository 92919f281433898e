// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/bumps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/fabrication/convex_distance.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {
namespace {

constexpr double edge_margin = 0.1;      // between a cap and the rim of its wall, mm
constexpr double bump_spacing = 0.2;     // between two caps of an interface, mm
constexpr double least_spread = 0.3;     // height of the triangle of three bumps, mm
constexpr double flat_clearance = 0.05;  // between a cap and the neighbour in the flat layout, mm
constexpr double least_diameter = 0.5;   // fraction of bump_diameter that shrinking stops at

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

Shape dimple_of(const Shape& bump, double clearance) {
  const double R = sphere_radius(bump.radius, bump.height);
  const double flat = R - bump.height;
  return {std::sqrt((R + clearance) * (R + clearance) - flat * flat), bump.height + clearance};
}

// The interval of the polygon at height v.
std::optional<std::array<double, 2>> chord(const Polygon& polygon, double v) {
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y() - v) * (b.y() - v) > 0) continue;
    for (double u :
         {a.y() == b.y() ? a.x() : a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x()),
          a.y() == b.y() ? b.x() : a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x())}) {
      low = std::min(low, u);
      high = std::max(high, u);
    }
  }
  if (low > high) return std::nullopt;
  return std::array<double, 2>{low, high};
}

bool far_apart(const std::vector<Vec2>& centres, double spacing) {
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((centres[i] - centres[j]).norm() < spacing) return false;
    }
  }
  return true;
}

// Rows from one side of the region to the other, the longer ones with one bump more.
std::vector<Vec2> in_rows(const Polygon& region, int count, int rows) {
  double low = 1e300, high = -1e300;
  for (const Vec2& p : region) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  if (high - low < least_spread) return {};
  std::vector<std::array<double, 2>> chords;  // -length, v
  for (int row = 0; row < rows; ++row) {
    const double v = low + (high - low) * (1e-6 + (1 - 2e-6) * row / (rows - 1));
    const auto c = chord(region, v);
    if (!c) return {};
    chords.push_back({(*c)[0] - (*c)[1], v});
  }
  std::stable_sort(chords.begin(), chords.end(), [](const auto& a, const auto& b) {
    return a[0] < b[0] - 1e-6;  // rows of like length keep their order
  });
  std::vector<Vec2> centres;
  for (int row = 0; row < rows; ++row) {
    const int bumps = count / rows + (row < count % rows ? 1 : 0);
    const auto c = *chord(region, chords[row][1]);
    // Single bumps in every row: at alternating ends, so that they do not stand in a line.
    const double single = count > rows ? 0.5 : row % 2 ? 0.8 : 0.2;
    for (int k = 0; k < bumps; ++k) {
      const double s = bumps == 1 ? single : static_cast<double>(k) / (bumps - 1);
      centres.emplace_back(c[0] + s * (c[1] - c[0]), chords[row][1]);
    }
  }
  return centres;
}

bool spread_out(const std::vector<Vec2>& centres) {
  return !centres.empty() && width(convex_hull(centres)) >= least_spread &&
         convex_hull(centres).size() >= 3;
}

// The corners of the region that span the largest triangle.
std::vector<Vec2> largest_triangle(const Polygon& region) {
  std::vector<Vec2> best;
  double largest = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (std::size_t j = i + 1; j < region.size(); ++j) {
      for (std::size_t k = j + 1; k < region.size(); ++k) {
        const double a = std::abs(wedge(region[j] - region[i], region[k] - region[i]));
        if (a <= largest) continue;
        largest = a;
        best = {region[i], region[j], region[k]};
      }
    }
  }
  return best;
}

class Planner {
 public:
  Planner(const DesignGeometry& geometry, const FlatPoses& poses, const Parameters& parameters)
      : geometry_(geometry), tiles_(geometry.tiles), poses_(poses), p_(parameters) {}

  BumpPlan run() {
    const int count = static_cast<int>(tiles_.contacts.size());
    plan_.recess = Array3::Zero(tiles_.tile_count(), 3);
    if (p_.bumps == "none") {
      build_bodies();
      return finish();
    }
    for (const Contact& contact : tiles_.contacts) set_recess(contact, wall_recess(p_));
    build_bodies();
    centres_.resize(count);
    shape_.resize(count);
    reason_.assign(count, "");
    parallel_ranges(count, [&](int begin, int end) {
      for (int k = begin; k < end; ++k) place(k);
    });
    parallel_ranges(count, [&](int begin, int end) {
      for (int k = begin; k < end; ++k) check_flat(k);
    });
    if (p_.bumps == "dimples") check_dimples();
    for (int k = 0; k < count; ++k) {
      if (reason_[k].empty()) continue;
      plan_.bare.push_back({k, reason_[k]});
      set_recess(tiles_.contacts[k], 0);
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
    parallel_ranges(count, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const auto r = plan_.recess.row(i);
        plan_.body[i] = tile_body(tiles_, geometry_.truncation, i, {r[0], r[1], r[2]});
        broken[i] =
            !find_face(plan_.body[i], body_tag::front) || !find_face(plan_.body[i], body_tag::back);
      }
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

  // Where the centres of caps of this radius may be, in the interface's plane.
  Polygon region(int k, const InterfacePlane& plane, double radius) const {
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
        corners.push_back(plane.to_plane(tiles_.frame[tile].to_world(plan_.body[tile].points[i])));
      }
      common = intersection(common, convex_hull(corners));
    }
    common = inset(common, radius + edge_margin);
    if (p_.bumps == "dimples" && !common.empty()) {  // hollows of neighbouring walls stay apart
      const double length = (geometry_.patches[k].point[1] - plane.origin).norm();
      common = clip(common, Vec2::UnitX(), length - 2 * radius - edge_margin);
      common = clip(common, -Vec2::UnitX(), -2 * radius - edge_margin);
    }
    if (p_.support == "soluble" && p_.support_drop >= p_.H_pin) {
      // The slab ends beside the walls: caps stay below its top, so that it need not cut them.
      const double top = p_.H_pin - p_.support_drop - p_.bump_height - radius;
      for (int tile : contact.tile) {
        const TileFrame& frame = tiles_.frame[tile];
        const Vec2 slope(frame.z.dot(plane.u), frame.z.dot(plane.v));
        common = clip(common, slope, top - frame.z.dot(plane.origin - frame.origin));
      }
    }
    return common;
  }

  void place(int k) {
    if (geometry_.patches[k].point_count < 3) {
      reason_[k] = "the tiles touch along their front edge only";
      return;
    }
    const InterfacePlane plane = make_plane(geometry_.patches[k]);
    const double least = std::max(2 * p_.bump_height, least_diameter * p_.bump_diameter);
    constexpr int steps = 5;
    for (int step = 0; step < steps; ++step) {
      const double diameter =
          p_.bump_diameter +
          (std::min(least, p_.bump_diameter) - p_.bump_diameter) * step / (steps - 1);
      const Shape bump{0.5 * diameter, p_.bump_height};
      const double reach =
          p_.bumps == "dimples" ? dimple_of(bump, p_.dimple_clearance).radius : bump.radius;
      const Polygon room = region(k, plane, reach);
      if (room.empty()) continue;
      std::vector<Vec2> found = in_rows(room, p_.bump_count, p_.bump_rows);
      if (!spread_out(found) || !far_apart(found, 2 * reach + bump_spacing)) {
        found = largest_triangle(room);
      }
      if (!spread_out(found) || !far_apart(found, 2 * reach + bump_spacing)) continue;
      std::sort(found.begin(), found.end(), [](const Vec2& a, const Vec2& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
      });
      for (const Vec2& p : found) centres_[k].push_back(plane.to_world(p));
      shape_[k] = bump;
      return;
    }
    reason_[k] = "too small for three bumps";
  }

  // The caps of one side of an interface in that tile's frame; bumps alternate along the edge.
  std::vector<WallCap> caps_of(int k, int s) const {
    const Contact& contact = tiles_.contacts[k];
    const int tile = contact.tile[s], wall = contact.side[s];
    const Vec3 normal = tiles_.wall_normal(tile, wall);
    const Shape hollow = dimple_of(shape_[k], p_.dimple_clearance);
    std::vector<WallCap> caps;
    for (std::size_t i = 0; i < centres_[k].size(); ++i) {
      const bool own = static_cast<int>(i % 2) == s;
      if (!own && p_.bumps != "dimples") continue;
      const Shape shape = own ? shape_[k] : hollow;
      const Vec3 centre =
          tiles_.frame[tile].to_local(centres_[k][i]) - plan_.recess(tile, wall) * normal;
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
    if (least < flat_clearance) reason_[k] = "bumps would touch the neighbour in the flat layout";
  }

  // Hollows must not pierce another face of their tile, nor meet one another.
  void check_dimples() {
    std::vector<std::vector<WallCap>> hollows(tiles_.tile_count());
    for (std::size_t k = 0; k < tiles_.contacts.size(); ++k) {
      if (!reason_[k].empty()) continue;
      std::array<std::vector<WallCap>, 2> caps{caps_of(k, 0), caps_of(k, 1)};
      bool fits = true;
      for (int s = 0; s < 2; ++s) {
        const int tile = tiles_.contacts[k].tile[s];
        for (const WallCap& cap : caps[s]) {
          if (cap.bump) continue;
          const CapSphere sphere = cap_sphere(cap.centre, cap.axis, cap.radius, cap.height);
          for (const BodyFace& face : plan_.body[tile].faces) {
            if (face.tag == body_tag::wall + cap.wall) continue;
            const Vec3 deepest = sphere.centre + sphere.radius * face.plane.normal;
            if (sphere.on_cap(face.plane.normal) &&
                face.plane.distance(deepest) > -2 * edge_margin) {
              fits = false;
            }
          }
          for (const WallCap& other : hollows[tile]) {
            if ((other.centre - cap.centre).norm() < other.radius + cap.radius + edge_margin) {
              fits = false;
            }
          }
        }
      }
      if (!fits) {
        reason_[k] = "its hollows would break into another face";
        continue;
      }
      for (int s = 0; s < 2; ++s) {
        for (const WallCap& cap : caps[s]) {
          if (!cap.bump) hollows[tiles_.contacts[k].tile[s]].push_back(cap);
        }
      }
    }
  }

  BumpPlan finish() {
    plan_.of_tile.resize(tiles_.tile_count());
    for (std::size_t k = 0; k < centres_.size(); ++k) {
      if (!reason_[k].empty()) continue;
      const double diameter = 2 * shape_[k].radius;
      if (plan_.smallest_diameter == 0 || diameter < plan_.smallest_diameter) {
        plan_.smallest_diameter = diameter;
      }
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
  BumpPlan plan_;
  std::vector<std::vector<Vec3>> centres_;  // per contact, in the unrecessed interface plane
  std::vector<Shape> shape_;
  std::vector<std::string> reason_;
};

}  // namespace

BumpPlan plan_bumps(const DesignGeometry& geometry, const FlatPoses& poses,
                    const Parameters& parameters) {
  return Planner(geometry, poses, parameters).run();
}

std::vector<Points3> bump_tips(const TileMesh& tiles, const BumpPlan& plan) {
  std::vector<std::vector<Vec3>> of_contact(tiles.contacts.size());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (const WallCap& cap : plan.of_tile[i]) {
      if (!cap.bump) continue;
      of_contact[cap.contact].push_back(
          tiles.frame[i].to_world(cap.centre + cap.height * cap.axis));
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
