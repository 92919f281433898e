// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/judgement.hpp"

#include <algorithm>

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

}  // namespace curveups
