// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/density.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "curveups/core/errors.hpp"

namespace curveups {

const std::vector<DensityModel>& density_models() {
#define CURVEUPS_ROW(function, name) {name, function},
  static const std::vector<DensityModel> models = {CURVEUPS_MEMBRANE_MODELS(CURVEUPS_ROW)};
#undef CURVEUPS_ROW
  return models;
}

const DensityModel& density_model(std::string_view name) {
  for (const DensityModel& model : density_models()) {
    if (model.name == name) return model;
  }
  throw InvalidInput("there is no membrane model '" + std::string(name) + "'",
                     "give one of the choices of membrane_model");
}

namespace {

// Half the difference of the diagonal of C, and its off-diagonal entry.
Eigen::Vector2d deviator(const Gradient32& F) {
  return {0.5 * (F.col(0).squaredNorm() - F.col(1).squaredNorm()), F.col(0).dot(F.col(1))};
}

}  // namespace

PrincipalStretches principal_stretches(const Gradient32& F) {
  PrincipalStretches out;
  out.l1 = 0.5 * F.squaredNorm() + deviator(F).norm();
  // The product from the cross product: a difference cancels.
  out.l2 = out.l1 > 0 ? F.col(0).cross(F.col(1)).squaredNorm() / out.l1 : 0.0;
  return out;
}

MembraneTension PrincipalStretches::tension() const {
  if (l1 < 1) return MembraneTension::slack;
  return l2 * l2 * l1 < 1 ? MembraneTension::wrinkled : MembraneTension::taut;
}

Eigen::Vector2d principal_direction(const Gradient32& F) {
  // Half the angle of the deviator, from whichever of sine and cosine is the larger.
  const Eigen::Vector2d d = deviator(F);
  const double radius = d.norm();
  if (!(radius > 0)) return {1, 0};
  const double larger = std::sqrt(0.5 * (1 + std::abs(d.x()) / radius)),
               smaller = 0.5 * std::abs(d.y()) / (radius * larger);
  const double sign = d.y() < 0 ? -1.0 : 1.0;
  return d.x() >= 0 ? Eigen::Vector2d(larger, sign * smaller)
                    : Eigen::Vector2d(smaller, sign * larger);
}

}  // namespace curveups
