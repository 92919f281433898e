// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/remedies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/layout/layout_figures.hpp"

namespace curveups {
namespace {

constexpr double more_area = 1.25;     // pins' room over A_pin_min
constexpr double taut = 0.9;           // the membrane's rest over its actuated length
constexpr double least_change = 0.02;  // relative; less is no remedy

// A pin's largest linear scale against the front triangle is 1 - shift - insets, which must be at
// least `least` (the root of the area's share).
struct PinScale {
  double shift;   // of the back edges, per mm of H_body
  double insets;  // least ones
  double least;
};

std::vector<PinScale> pin_scales(const DesignGeometry& geometry, const Parameters& p,
                                 const std::vector<int>& pins) {
  const TileMesh& tiles = geometry.tiles;
  std::vector<PinScale> out;
  for (int i : pins) {
    const double half_round = 1 / (2 * tiles.area(i));
    const Vec3 length = tiles.length.row(i);
    const double least = std::sqrt(more_area * p.A_pin_min / tiles.area(i));
    const double shift = tiles.back_shift.row(i).dot(length) * half_round / p.H_body;
    for (Side side : {Side::front, Side::back}) {
      const Vec3 lower = geometry.pin_bounds.lower.row(i).segment<3>(inset_index(side, 0));
      out.push_back({side == Side::back ? shift : 0.0, lower.dot(length) * half_round, least});
    }
  }
  return out;
}

}  // namespace

Remedies find_remedies(const Design& design, const std::vector<int>& pins,
                       const std::vector<std::array<int, 2>>& weak) {
  const Parameters& p = design.parameters;
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, p);
  Remedies out;
  if (!pins.empty()) {
    double thickness = std::numeric_limits<double>::infinity(), larger = 0;
    for (const PinScale& pin : pin_scales(geometry, p, pins)) {
      const double slack = 1 - pin.insets - pin.least;
      if (pin.shift * thickness > slack) thickness = slack / pin.shift;
      const double rest = 1 - pin.shift * p.H_body;  // what no larger tile changes
      larger = rest > 0 ? std::max(larger, (pin.insets + pin.least) / rest)
                        : std::numeric_limits<double>::infinity();
    }
    thickness = std::floor(10 * thickness) / 10;
    if (thickness >= find_parameter("H_body")->minimum &&
        thickness < (1 - least_change) * p.H_body) {
      out.H_body = thickness;
    }
    const double length = std::ceil(10 * larger * p.L) / 10;
    if (larger > 1 + least_change && length <= find_parameter("L")->maximum) out.L = length;
  }
  if (!weak.empty()) {
    const Eigen::VectorXd springs =
        spring_ratios(geometry, p, fit_poses(geometry.tiles, design.T), design.q);
    double longest = 0;
    for (std::size_t k = 0; k < geometry.tiles.contacts.size(); ++k) {
      const std::array<int, 2>& tile = geometry.tiles.contacts[k].tile;
      const bool named = std::any_of(weak.begin(), weak.end(), [&](const std::array<int, 2>& w) {
        return std::minmax(w[0], w[1]) == std::minmax(tile[0], tile[1]);
      });
      if (!named) continue;
      longest = std::max(longest, springs.segment<2>(2 * static_cast<Eigen::Index>(k)).maxCoeff());
    }
    const double tau = std::ceil(10 * p.tau * longest / taut) / 10;
    if (tau > (1 + least_change) * p.tau && tau <= find_parameter("tau")->maximum) out.tau = tau;
  }
  return out;
}

}  // namespace curveups
