// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/clearance.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

// A tile as convex parts (body, front pin, back pin) and the spheres of its bumps.
struct Parts {
  std::array<ConvexBody, 3> convex;
  std::vector<CapSphere> caps;
  Eigen::AlignedBox3d box;
};

Parts make_parts(const TileBodies& bodies, int tile, const ConvexBody& body,
                 const RigidMotion& motion, bool with_caps) {
  const TileMesh& tiles = bodies.geometry.tiles;
  const double* q = bodies.q.row(tile).data();
  const double H_pin = bodies.parameters.H_pin, H_body = tiles.H_body;
  Parts parts;
  parts.convex[0] = moved(body, motion);
  parts.convex[1] = moved(make_prism(pin_corners(tiles, tile, Side::front, q), 0, H_pin), motion);
  parts.convex[2] =
      moved(make_prism(pin_corners(tiles, tile, Side::back, q), -H_body - H_pin, -H_body), motion);
  for (const ConvexBody& part : parts.convex) parts.box.extend(bounding_box(part));
  if (!with_caps) return parts;
  for (const WallCap& cap : bodies.bumps.of_tile[tile]) {
    if (!cap.bump) continue;
    const Vec3 apex = motion(cap.centre + cap.height * cap.axis);
    parts.caps.push_back(
        cap_sphere(motion(cap.centre), motion.R * cap.axis, cap.radius, cap.height));
    parts.box.extend(apex - Vec3::Constant(cap.radius));
    parts.box.extend(apex + Vec3::Constant(cap.radius));
  }
  return parts;
}

double tile_distance(const Parts& a, const Parts& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexBody& p : a.convex) {
    const Eigen::AlignedBox3d box = bounding_box(p);
    for (const ConvexBody& q : b.convex) {
      if (box.exteriorDistance(bounding_box(q)) < least) least = std::min(least, distance(p, q));
    }
  }
  auto caps_against = [&](const Parts& owner, const Parts& other) {
    for (const CapSphere& cap : owner.caps) {
      for (const ConvexBody& part : other.convex) least = std::min(least, distance(cap, part));
    }
  };
  caps_against(a, b);
  caps_against(b, a);
  for (const CapSphere& s : a.caps) {
    for (const CapSphere& t : b.caps) least = std::min(least, distance(s, t));
  }
  return std::max(0.0, least);
}

// Pairs of tiles whose boxes, grown by `reach`, overlap.
std::vector<std::array<int, 2>> near_pairs(const std::vector<Parts>& parts, double reach) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Parts& part : parts) boxes.push_back(grown(part.box, 0.5 * reach));
  return overlapping_boxes(boxes);
}

template <class Make>
std::vector<Parts> all_parts(const TileBodies& bodies, Make make) {
  std::vector<Parts> parts(bodies.geometry.tiles.tile_count());
  parallel_for(static_cast<int>(parts.size()), [&](int i) { parts[i] = make(i); });
  return parts;
}

template <class Measure>
std::vector<double> measure_pairs(const std::vector<std::array<int, 2>>& pairs, Measure measure) {
  std::vector<double> values(pairs.size());
  parallel_for(static_cast<int>(pairs.size()),
               [&](int k) { values[k] = measure(pairs[k][0], pairs[k][1]); });
  return values;
}

Finding reason(const char* kind, const PairFigure& figure) {
  const Finding::Pairs pair = {figure.tiles};
  return {kind, tiles_of(pair), {{"value", figure.value}, {"at", tiles_of(pair)}}};
}

}  // namespace

PairFigure min_clearance_flat(const TileBodies& bodies) {
  const std::vector<Parts> parts = all_parts(bodies, [&](int i) {
    return make_parts(bodies, i, bodies.bumps.body[i], flat_motion(bodies.poses, i, 0), true);
  });
  PairFigure out{std::numeric_limits<double>::infinity(), {-1, -1}};
  if (parts.size() < 2) return out;
  // Pairs further apart than the reach can't be the nearest once one within it is found.
  for (double reach = std::max(0.1, 2 * bodies.parameters.d_gap_min);; reach *= 4) {
    const auto pairs = near_pairs(parts, reach);
    const std::vector<double> values =
        measure_pairs(pairs, [&](int i, int j) { return tile_distance(parts[i], parts[j]); });
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (values[k] < out.value) out = {values[k], pairs[k]};
    }
    const bool all = pairs.size() == parts.size() * (parts.size() - 1) / 2;
    if (out.value <= reach || all) return out;
  }
}

PairFigure max_overlap_actuated(const TileBodies& bodies) {
  const TileMesh& tiles = bodies.geometry.tiles;
  const std::vector<Parts> parts = all_parts(bodies, [&](int i) {
    return make_parts(bodies, i, tile_body(tiles, bodies.geometry.truncation, i), tiles.frame[i],
                      false);
  });
  const auto pairs = near_pairs(parts, 0);
  const std::vector<double> values = measure_pairs(pairs, [&](int i, int j) {
    double sum = 0;
    for (const ConvexBody& p : parts[i].convex) {
      for (const ConvexBody& q : parts[j].convex) sum += common_volume(p, q);
    }
    return sum;
  });
  PairFigure out;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (values[k] > out.value) out = {values[k], pairs[k]};
  }
  return out;
}

std::vector<Finding> body_reasons(const PairFigure& flat, const PairFigure& actuated) {
  std::vector<Finding> reasons;
  if (flat.value <= 0) reasons.push_back(reason("bodies_meet", flat));
  if (actuated.value > tolerance::overlap_volume)
    reasons.push_back(reason("bodies_overlap", actuated));
  return reasons;
}

}  // namespace curveups
