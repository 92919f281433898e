// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/judgement.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {

Judgement judge(const Eigen::VectorXd& normal, double floor, double f_min_ratio) {
  Judgement out;
  out.normal = normal;
  for (double force : normal) out.mean += force;
  out.mean /= std::max<double>(1, static_cast<double>(normal.size()));
  out.f_min = f_min_ratio * out.mean;
  out.least = 1e300;
  if (!(out.f_min > 0)) {
    throw InfeasibleDesign("the membranes do not press the tiles together",
                           "raise tau, or lower p_max so that pins pull more strongly");
  }
  for (double force : normal) {
    const double f = force / out.f_min;
    out.weak += !presses(force, out.f_min);
    out.least = std::min(out.least, f);
    out.missing += std::max(0.0, force_goal - f);
  }
  out.floor = floor / out.f_min;
  if (out.floor < floor_goal) out.missing += floor_goal - out.floor;
  return out;
}

std::vector<BlockedContact> weak_contacts(const std::vector<ContactPoint>& points,
                                          const Judgement& judgement,
                                          const std::vector<std::array<int, 2>>& critical) {
  std::vector<std::pair<std::array<int, 2>, double>> least;  // force of each, in units of f_min
  auto add = [&](const std::array<int, 2>& tiles, double force) {
    const auto known = std::find_if(least.begin(), least.end(),
                                    [&](const auto& contact) { return contact.first == tiles; });
    if (known == least.end()) {
      least.push_back({tiles, force});
    } else {
      known->second = std::min(known->second, force);
    }
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double force = judgement.normal(static_cast<Eigen::Index>(p)) / judgement.f_min;
    if (points[p].contact >= 0 && force < 1) add(points[p].tile, force);
  }
  std::string kind = "weak_contact";
  if (least.empty() && judgement.is_short_of_floor()) {
    kind = "weak_contact.friction";
    for (const std::array<int, 2>& pair : critical) add(pair, judgement.floor);
  }
  std::vector<BlockedContact> out;
  for (const auto& [tiles, force] : least) {
    const Finding::Pairs pair = {tiles};
    const std::vector<Finding> why = {{"held_by_nothing"}};
    out.push_back(
        {tiles, {kind, tiles_of(pair), {{"contact", pair}, {"share", force}, {"why", why}}}});
  }
  return out;
}

}  // namespace curveups
