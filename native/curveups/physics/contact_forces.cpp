// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/errors.hpp"

namespace curveups {

std::vector<ContactPoint> interface_points(const TileMesh& tiles,
                                           const std::vector<ContactPatch>& patches) {
  std::vector<ContactPoint> points;
  points.reserve(4 * patches.size());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    for (int l = 0; l < patches[k].point_count; ++l) {
      points.push_back(
          {patches[k].point[l], patches[k].normal, tiles.contacts[k].tile, static_cast<int>(k)});
    }
  }
  return points;
}

ContactForces solve_contact_forces(BalanceSystem& system, const Wrenches& loads) {
  const int count = system.point_count();
  ContactForces out;
  Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * count);
  if (!system.factorize(std::vector<Eigen::Matrix3d>(count, Eigen::Matrix3d::Identity()))) {
    throw no_balance();
  }
  // The second and third round remove rounding (and what the shift of a singular system left).
  const Eigen::VectorXd b = system.restrict(loads);
  for (int round = 0; round < 3; ++round) {
    f -= system.apply_transposed(system.solve(system.apply(f) + b));
  }
  const Eigen::VectorXd rest = system.apply(f) + b;
  const Wrenches total = loads + system.wrenches(f);
  double mean = 0;
  for (int i = 0; i < loads.rows(); ++i) mean += loads.row(i).head<3>().norm() / loads.rows();
  out.imbalance = mean > 0 && rest.size() > 0 ? rest.cwiseAbs().maxCoeff() / mean : 0;
  if (out.imbalance > 1e-6) {
    for (int i = 0; i < total.rows(); ++i) {
      const double force = total.row(i).head<3>().cwiseAbs().maxCoeff(),
                   torque = total.row(i).tail<3>().cwiseAbs().maxCoeff() / system.lever();
      if (system.has_rows(i) && std::max(force, torque) > 1e-6 * mean) {
        out.unbalanced_tiles.push_back(i);
      }
    }
  }
  out.force = Eigen::Map<const Points3>(f.data(), count, 3);
  if (count > 0) {
    out.normal_min = out.force.col(0).minCoeff(&out.weakest_point);
    for (double normal : out.force.col(0)) out.normal_mean += normal;
    out.normal_mean /= count;
  }
  return out;
}

}  // namespace curveups
