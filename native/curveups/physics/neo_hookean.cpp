// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/neo_hookean.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace curveups {

namespace {

// Of C: half the difference of its diagonal, and its other entry.
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

Density neo_hookean(const Gradient32& F, bool second) {
  using Eigen::Matrix3d;
  using Eigen::Vector3d;
  const Vector3d f1 = F.col(0), f2 = F.col(1), n = f1.cross(f2);
  // As |f1 x f2|^2: the difference form of det C goes negative by cancellation.
  const double s = 1 / n.squaredNorm();
  Vector6 a;  // gradient of |n|^2 / 2
  a << f2.cross(n), n.cross(f1);
  Density out;
  const double norm = F.squaredNorm();
  out.value = norm + s - 3;
  out.gradient << f1, f2;
  out.gradient = 2 * (out.gradient - s * s * a);
  if (!second) return out;
  const Matrix3d off =
      2 * f1 * f2.transpose() - f2 * f1.transpose() - f1.dot(f2) * Matrix3d::Identity();
  Matrix6 bend;  // Hessian of |n|^2 / 2
  bend.topLeftCorner<3, 3>() = f2.squaredNorm() * Matrix3d::Identity() - f2 * f2.transpose();
  bend.bottomRightCorner<3, 3>() = f1.squaredNorm() * Matrix3d::Identity() - f1 * f1.transpose();
  bend.topRightCorner<3, 3>() = off;
  bend.bottomLeftCorner<3, 3>() = off.transpose();
  out.hessian = 2 * Matrix6::Identity() + (8 * s * s * s) * a * a.transpose() - (2 * s * s) * bend;
  return out;
}

}  // namespace curveups
