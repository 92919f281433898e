// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/body_part.hpp"

#include <functional>

namespace curveups {
namespace {

// A part starts from at most this share of the bodies, and all others feel less than this share of
// the largest force.
constexpr double worst_share = 0.01, rest_share = 0.1;

}  // namespace

BodyPart worst_part(const Eigen::VectorXd& forces, const std::vector<RigidBody>& bodies,
                    const std::vector<std::vector<int>>& joined) {
  BodyPart part;
  if (forces.size() == 0) return part;
  std::vector<double> sorted(forces.data(), forces.data() + forces.size());
  const auto rest = sorted.begin() + static_cast<int>(worst_share * sorted.size());
  std::nth_element(sorted.begin(), rest, sorted.end(), std::greater<double>());
  const double level = rest_share * forces.maxCoeff();
  if (!(*rest < level)) return part;

  part.number.assign(bodies.size(), -1);
  const auto take = [&](int body) {
    if (part.number[body] >= 0) return;
    part.number[body] = static_cast<int>(part.bodies.size());
    part.bodies.push_back(body);
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (forces(i) > level) take(static_cast<int>(i));
  }
  const std::size_t worst = part.bodies.size();
  for (std::size_t k = 0; k < worst; ++k) {
    for (int body : joined[part.bodies[k]]) {
      if (!bodies[body].fixed) take(body);
    }
  }
  part.moving = static_cast<int>(part.bodies.size());
  for (int k = 0; k < part.moving; ++k) {
    for (int body : joined[part.bodies[k]]) take(body);
  }
  return part;
}

}  // namespace curveups
