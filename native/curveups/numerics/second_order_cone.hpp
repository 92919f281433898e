// SPDX-License-Identifier: LGPL-2.1-or-later
// The cone |(u1, u2)| <= u0 and its Nesterov-Todd scaling, as used by interior-point methods
// (L. Vandenberghe, "The CVXOPT linear and quadratic cone program solvers", 2010).
#pragma once

#include "curveups/core/types.hpp"

namespace curveups {

// Jordan product, and its inverse: the d with nu o d = r.
Vec3 cone_product(const Vec3& u, const Vec3& v);
Vec3 cone_divide(const Vec3& nu, const Vec3& r);

// The largest step in [0, limit] that keeps u + step d in the cone; u inside.
double cone_step(const Vec3& u, const Vec3& d, double limit);

// W symmetric with W lambda = W^-1 z = nu, for z and lambda inside the cone.
struct ConeScaling {
  Eigen::Matrix3d W, W_inverse, W_squared;
  // The inverse of the tangential 2 x 2 block of W^-2, which W^-2 itself has not the digits for.
  Eigen::Matrix2d tangential;
  Vec3 nu;
};
ConeScaling cone_scaling(const Vec3& z, const Vec3& lambda);

}  // namespace curveups
