// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/judgement.hpp"

#include <algorithm>

#include "curveups/core/errors.hpp"

namespace curveups {

Judgement judge(const std::vector<ContactPoint>& points, const Eigen::VectorXd& normal,
                const Floors& floors, double f_min_ratio, const RepairOptions& options) {
  Judgement out;
  out.normal = normal;
  int count = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact < 0) continue;
    out.mean += normal(static_cast<Eigen::Index>(p));
    ++count;
  }
  out.mean /= std::max(1, count);
  out.f_min = f_min_ratio * out.mean;
  out.least = 1e300;
  if (!(out.f_min > 0)) {
    throw InfeasibleDesign("the membranes do not press the tiles together",
                           "raise tau, or lower p_max so that pins pull more strongly");
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact < 0) continue;
    const double f = normal(static_cast<Eigen::Index>(p)) / out.f_min;
    out.weak += !presses(normal(static_cast<Eigen::Index>(p)), out.f_min);
    out.least = std::min(out.least, f);
    out.missing += std::max(0.0, options.goal - f);
  }
  for (std::size_t k = 0; k < floors.size(); ++k) {
    out.floor[k] = floors[k] / out.f_min;
    if (out.floor[k] < options.floor_goal) out.missing += options.floor_goal - out.floor[k];
  }
  return out;
}

}  // namespace curveups
