// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/pin_bounds.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curveups/design/joints.hpp"
#include "curveups/design/print_constants.hpp"

namespace curveups {
namespace {

// Lower bound of inset t: p_min from the recessed edge, and no nearer to a facing pin than concave
// folds allow.
double lower_bound(const TileMesh& tiles, const Parameters& p, int tile, Side side, int t,
                   double p_min) {
  const int edge = tiles.topology.edge_of(tile, t);
  const bool interior = tiles.topology.neighbour(tile, t) >= 0;
  const double half = 0.5 * tiles.dihedral(tile, t);
  const double recess = interior && !tiles.cut[edge] ? wall_recess(p) / std::cos(half) : 0.0;
  const double bend = side == Side::front ? -half : half;  // positive: concave on this side
  const double facing = bend > 0 ? p.H_pin * std::tan(bend) + pin_clearance : 0.0;
  return std::max(recess + p_min, facing);
}

constexpr double between = 0.02;  // mm from a lower bound above the upper one to the upper one then
constexpr double spare = 1.02;    // times A_pin_floor where bounds give way, for an interior

// least: inset for a hole of a joint behind edge t, 0 without one. p_max does not count there, for
// no membrane pulls across a joint.
double upper_bound(const TileMesh& tiles, const Parameters& p, int tile, Side side, int t,
                   double least) {
  if (least > 0) return std::max(p.p_max, least + between);
  const int edge = tiles.topology.edge_of(tile, t);
  if (tiles.topology.neighbour(tile, t) < 0 || tiles.cut[edge]) return p.p_max;
  const double half = 0.5 * tiles.dihedral(tile, t);
  const double bend = side == Side::front ? half : -half;  // positive: convex on this side
  if (bend <= 0) return p.p_max;
  return std::min(p.p_max, p.H_pin / std::tan(bend) - pin_clearance);
}

// Add keep-outs of the pin corners that a plane reaches within the bounds. levels: z of the pin's
// foot and top.
void add_keepouts(const TileMesh& tiles, int tile, Side side, const TruncationPlane& truncation,
                  double clearance, const std::array<double, 2>& levels, PinRegion& region) {
  const Plane& plane = truncation.plane;
  const Vec2 normal = plane.normal.head<2>();
  if (normal.norm() < 1e-9) return;
  const std::array<Vec2, 3>& face = tiles.corners(tile, side);
  for (int t = 0; t < 3; ++t) {
    const Vec2 along = (face[next3(t)] - face[t]).normalized();
    const Vec2 back = (face[prev3(t)] - face[t]).normalized();
    const double sine = wedge(along, back);
    const double level = std::max(plane.normal.z() * levels[0], plane.normal.z() * levels[1]);
    const PinKeepout keepout{
        tile,
        side,
        t,
        -normal.dot(along) / sine,
        -normal.dot(back) / sine,
        normal.dot(face[t]) + level - plane.offset + clearance * normal.norm()};
    const double least =
        keepout.a_prev * (keepout.a_prev > 0 ? region.lower : region.upper)[prev3(t)] +
        keepout.a_here * (keepout.a_here > 0 ? region.lower : region.upper)[t];
    if (least < keepout.bound) region.keepouts.push_back(keepout);
  }
}

// Least sum l_t q_t within bounds and keep-outs: a linear program in three unknowns, solved by
// visiting the vertices of its polyhedron. Infinite where it has none.
double least_inset_sum(const Vec3& weight, const PinRegion& region) {
  std::vector<std::pair<Vec3, double>> half_spaces;  // a . q >= b
  for (int t = 0; t < 3; ++t) {
    half_spaces.push_back({Vec3::Unit(t), region.lower[t]});
    half_spaces.push_back({-Vec3::Unit(t), -region.upper[t]});
  }
  for (const PinKeepout& keepout : region.keepouts) {
    Vec3 a = Vec3::Zero();
    a(prev3(keepout.corner)) = keepout.a_prev;
    a(keepout.corner) = keepout.a_here;
    half_spaces.push_back({a, keepout.bound});
  }
  double best = std::numeric_limits<double>::infinity();
  const std::size_t n = half_spaces.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        Eigen::Matrix3d m;
        m << half_spaces[i].first.transpose(), half_spaces[j].first.transpose(),
            half_spaces[k].first.transpose();
        const double det = m.determinant();
        if (std::abs(det) < 1e-9) continue;
        const Vec3 q =
            m.inverse() * Vec3(half_spaces[i].second, half_spaces[j].second, half_spaces[k].second);
        if (weight.dot(q) >= best) continue;
        const bool feasible =
            std::all_of(half_spaces.begin(), half_spaces.end(),
                        [&](const auto& h) { return h.first.dot(q) >= h.second - 1e-9; });
        if (feasible) best = weight.dot(q);
      }
    }
  }
  return best;
}

}  // namespace

PinRegion pin_region(const TileMesh& tiles, const Truncation& truncation, const Parameters& p,
                     int tile, Side side, double p_min, const std::array<double, 3>& least) {
  const double face_z = side == Side::front ? 0.0 : -tiles.H_body;
  const double top_z = side == Side::front ? p.H_pin : face_z - p.H_pin;
  PinRegion out;
  for (int t = 0; t < 3; ++t) {
    out.lower[t] = std::max(lower_bound(tiles, p, tile, side, t, p_min), least[t]);
    out.upper[t] = std::max(out.lower[t] + between, upper_bound(tiles, p, tile, side, t, least[t]));
  }
  const auto& planes = side == Side::front ? truncation.front_pins : truncation.of_tile;
  for (const TruncationPlane& plane : planes[tile]) {
    add_keepouts(tiles, tile, side, plane, pin_clearance, {face_z, top_z}, out);
  }
  const Vec3 weight = tiles.length.row(tile);
  double sum = out.keepouts.empty() ? weight.dot(Eigen::Map<const Vec3>(out.lower.data()))
                                    : least_inset_sum(weight, out);
  if (side == Side::back) sum += tiles.back_shift.row(tile).dot(tiles.length.row(tile));
  out.scale = 1 - sum / (2 * tiles.area(tile));
  out.area = out.scale > 0 ? tiles.area(tile) * out.scale * out.scale : 0.0;
  return out;
}

namespace {

// Largest value between `low` and `high` that fits, by bisection; low where none does.
template <class Fits>
double largest_fitting(double low, double high, Fits fits) {
  for (int k = 0; k < 30; ++k) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

// Region beside holes of joints, or beside the largest share of them that A_pin_floor allows, so
// that bounds follow vertices without a jump. least: set to the insets for them.
PinRegion beside_holes(const TileMesh& tiles, const Truncation& truncation, const Parameters& p,
                       int tile, Side side, const Array6& joint, std::array<double, 3>& least) {
  const auto part = [&](double share) {
    for (int t = 0; t < 3; ++t) least[t] = share * joint(tile, inset_index(side, t));
    return pin_region(tiles, truncation, p, tile, side, p.p_min, least);
  };
  const auto fits = [&](double share) { return part(share).area >= spare * p.A_pin_floor; };
  return part(fits(1) ? 1 : largest_fitting(0, 1, fits));
}

}  // namespace

PinBounds compute_pin_bounds(const TileMesh& tiles, const Truncation& truncation,
                             const Parameters& p) {
  const int count = tiles.tile_count();
  PinBounds out;
  out.lower.resize(count, 6);
  out.upper.resize(count, 6);
  out.area.resize(count, 2);
  out.least_area.resize(count, 2);
  const Array6 joint = joint_insets(tiles, p);
  for (int i = 0; i < count; ++i) {
    for (Side side : {Side::front, Side::back}) {
      std::array<double, 3> least{};  // for holes of joints
      auto with = [&](double p_min) { return pin_region(tiles, truncation, p, i, side, p_min); };
      PinRegion region = with(p.p_min);
      if (region.area < p.A_pin_floor && p.p_floor < p.p_min) {
        const double fitting = largest_fitting(0.1 * p.p_min, p.p_min, [&](double p_min) {
          return with(p_min).area >= spare * p.A_pin_floor;
        });
        const double lowered = std::max(fitting, p.p_floor);
        const PinRegion before = std::exchange(region, with(lowered));
        for (int t = 0; t < 3; ++t) {
          // p_min does not count where facing pins bound the inset.
          if (region.lower[t] < before.lower[t]) {
            out.relaxed.push_back({"p_min", i, side, t, p.p_min, lowered});
          }
        }
      } else if (joint.row(i).maxCoeff() > 0) {
        region = beside_holes(tiles, truncation, p, i, side, joint, least);
      }
      for (int t = 0; t < 3; ++t) {
        const double upper = upper_bound(tiles, p, i, side, t, least[t]);
        if (region.upper[t] > upper) {
          out.relaxed.push_back({"p_max", i, side, t, upper, region.upper[t]});
        }
      }
      for (int t = 0; t < 3; ++t) {
        out.lower(i, inset_index(side, t)) = region.lower[t];
        out.upper(i, inset_index(side, t)) = region.upper[t];
      }
      // If the feasible set is nearly a point, ask for 99 % of its area, so that an interior
      // exists; for more where that is below A_pin_floor.
      const bool small = region.area < p.A_pin_min * (1 + 1e-4);
      const double possible =
          std::max(0.99 * region.area, std::min(1.001 * p.A_pin_floor, 0.999 * region.area));
      out.least_area(i, static_cast<int>(side)) = small ? possible : p.A_pin_min;
      out.area(i, static_cast<int>(side)) = region.area;
      if (small) out.small.push_back({i, side, region.area});
      out.keepouts.insert(out.keepouts.end(), region.keepouts.begin(), region.keepouts.end());
    }
  }
  return out;
}

}  // namespace curveups
