// SPDX-License-Identifier: LGPL-2.1-or-later
// Energy densities of membranes, per kappa: multiply by kappa h (half the shear modulus times the
// rest thickness) and the rest area.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "curveups/design/membrane_models.hpp"

namespace curveups {

using Gradient32 = Eigen::Matrix<double, 3, 2>;  // F: columns f1, f2, rest plane to space
using Vector6 = Eigen::Matrix<double, 6, 1>;     // (f1, f2)
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Taut: both principal stresses pull. Wrinkled: one does. Slack: none. (The plain neo-Hookean
// density bears compression; its states say where the relaxed one would differ.)
enum class MembraneTension : unsigned char { taut = 0, wrinkled = 1, slack = 2 };

struct Density {
  double value = 0;
  Vector6 gradient = Vector6::Zero();
  Matrix6 hessian = Matrix6::Zero();  // zero without `second`
};

// Each density is a function of F in a file of its name: value, gradient and (with `second`)
// Hessian by F. regularization: for densities that leave slack parts without a unique position.
#define CURVEUPS_DECLARE(function, name) \
  Density function(const Gradient32& F, double regularization, bool second);
CURVEUPS_MEMBRANE_MODELS(CURVEUPS_DECLARE)
#undef CURVEUPS_DECLARE

struct DensityModel {
  std::string_view name;  // as the parameter membrane_model has it
  Density (*evaluate)(const Gradient32& F, double regularization, bool second);
};

const std::vector<DensityModel>& density_models();
// Throws InvalidInput for an unknown name.
const DensityModel& density_model(std::string_view name);

// Squared principal stretches l1 >= l2 of F: the eigenvalues of C = F^T F.
struct PrincipalStretches {
  double l1, l2;
  MembraneTension tension() const;
};
PrincipalStretches principal_stretches(const Gradient32& F);

// Unit eigenvector of C for l1; that for l2 is the same turned by +90 degrees.
Eigen::Vector2d principal_direction(const Gradient32& F);

}  // namespace curveups
