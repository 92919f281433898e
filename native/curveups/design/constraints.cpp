// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/constraints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

// Corners of both faces of all tiles in the flat plane.
using Faces = std::array<std::array<Vec2, 3>, 2>;

std::vector<Faces> place_all(const TileMesh& tiles, const FlatPoses& poses) {
  std::vector<Faces> placed(tiles.tile_count());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    placed[i] = {place(poses, i, tiles.front[i]), place(poses, i, tiles.back[i])};
  }
  return placed;
}

// Signed distance of p from the line of edge t, positive outside the triangle.
double outside(const std::array<Vec2, 3>& triangle, int t, const Vec2& p) {
  const Vec2 edge = (triangle[next3(t)] - triangle[t]).normalized();
  return -wedge(edge, p - triangle[t]);
}

double separation_along(const Faces& tile, int t, const Faces& other) {
  double least = std::numeric_limits<double>::infinity();
  for (int s = 0; s < 2; ++s) {
    for (const Vec2& p : other[s]) least = std::min(least, outside(tile[s], t, p));
  }
  return least;
}

// Two tips that face one another are separated by less along an edge normal than they are apart:
// candidates are all pairs whose circles come within this many times the clearance. Circles,
// because the answer must not depend on how the layout is turned.
constexpr double reach = 3;

}  // namespace

Eigen::VectorXd contact_gaps(const TileMesh& tiles, const FlatPoses& poses) {
  const std::vector<Faces> placed = place_all(tiles, poses);
  Eigen::VectorXd gaps(static_cast<Eigen::Index>(tiles.contacts.size()));
  for (std::size_t k = 0; k < tiles.contacts.size(); ++k) {
    const Contact& contact = tiles.contacts[k];
    double least = std::numeric_limits<double>::infinity();
    for (int d = 0; d < 2; ++d) {
      const int i = contact.tile[d], t = contact.side[d], j = contact.tile[1 - d],
                u = contact.side[1 - d];
      for (int s = 0; s < 2; ++s) {
        for (int end : {u, next3(u)}) {
          least = std::min(least, outside(placed[i][s], t, placed[j][s][end]));
        }
      }
    }
    gaps[static_cast<Eigen::Index>(k)] = least;
  }
  return gaps;
}

std::vector<Separation> find_close_pairs(const TileMesh& tiles, const FlatPoses& poses,
                                         double clearance) {
  const std::vector<Faces> placed = place_all(tiles, poses);
  const int count = static_cast<int>(placed.size());
  std::vector<Eigen::AlignedBox3d> boxes(count);
  std::vector<Vec2> middle(count);
  std::vector<double> radius(count, 0);
  for (int i = 0; i < count; ++i) {
    middle[i] = (placed[i][0][0] + placed[i][0][1] + placed[i][0][2]) / 3;
    for (const auto& face : placed[i]) {
      for (const Vec2& p : face) radius[i] = std::max(radius[i], (p - middle[i]).norm());
    }
    const double half = radius[i] + 0.5 * reach * clearance;
    const Vec3 at(middle[i].x(), middle[i].y(), 0), out(half, half, 0);
    boxes[i] = {at - out, at + out};
  }
  std::vector<Separation> out;
  for (const auto& [i, j] : overlapping_boxes(boxes)) {
    const double apart = (middle[i] - middle[j]).norm() - radius[i] - radius[j];
    if (apart > reach * clearance) continue;
    Separation best{i, 0, j, -std::numeric_limits<double>::infinity()};
    for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)}) {
      for (int t = 0; t < 3; ++t) {
        const double d = separation_along(placed[a], t, placed[b]);
        if (d > best.distance) best = {a, t, b, d};
      }
    }
    if (best.distance < clearance) out.push_back(best);
  }
  return out;
}

ConstraintReport check_constraints(const DesignGeometry& geometry, const FlatCorners& corners,
                                   const Array6& q, const Parameters& p) {
  const TileMesh& tiles = geometry.tiles;
  ConstraintReport report;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) {
      const double flat =
          (corners.row(i).segment<2>(2 * next3(t)) - corners.row(i).segment<2>(2 * t)).norm();
      report.max_rigidity_mm =
          std::max(report.max_rigidity_mm, std::abs(flat - tiles.length(i, t)));
    }
  }
  const FlatPoses poses = fit_poses(tiles, corners);
  double least_gap = p.d_gap_min;
  const Eigen::VectorXd gaps = contact_gaps(tiles, poses);
  if (gaps.size()) least_gap = std::min(least_gap, gaps.minCoeff());
  for (const Separation& pair : find_close_pairs(tiles, poses, p.d_gap_min)) {
    least_gap = std::min(least_gap, pair.distance);
    if (pair.distance < p.d_gap_min - tolerance::constraint) {
      report.close_pairs.push_back(
          {std::min(pair.tile, pair.other), std::max(pair.tile, pair.other)});
    }
  }
  report.max_gap_violation_mm = p.d_gap_min - least_gap;

  const PinBounds& bounds = geometry.pin_bounds;
  report.relaxed = bounds.relaxed;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int k = 0; k < 6; ++k) {
      report.max_pin_bound_violation_mm =
          std::max({report.max_pin_bound_violation_mm, bounds.lower(i, k) - q(i, k),
                    q(i, k) - bounds.upper(i, k)});
    }
    for (Side side : {Side::front, Side::back}) {
      const double area = pin_area(tiles, i, side, q.row(i).data());
      report.max_pin_area_violation_mm2 = std::max(
          report.max_pin_area_violation_mm2, bounds.least_area(i, static_cast<int>(side)) - area);
      if (area < p.A_pin_min - tolerance::constraint) report.small_pins.push_back({i, side, area});
    }
  }
  for (const PinKeepout& keepout : bounds.keepouts) {
    const double* own = q.row(keepout.tile).data() + inset_index(keepout.side, 0);
    const double value =
        keepout.a_prev * own[prev3(keepout.corner)] + keepout.a_here * own[keepout.corner];
    report.max_pin_bound_violation_mm =
        std::max(report.max_pin_bound_violation_mm, keepout.bound - value);
  }
  return report;
}

}  // namespace curveups
