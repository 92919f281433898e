// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/second_order_cone.hpp"

#include <algorithm>
#include <cmath>

namespace curveups {
namespace {

// u^T J u without cancellation near the boundary.
double hyperbolic_norm(const Vec3& u) {
  const double t = u.tail<2>().norm();
  return (u.x() - t) * (u.x() + t);
}

Vec3 reflect(const Vec3& u) { return {u.x(), -u.y(), -u.z()}; }

}  // namespace

Vec3 cone_product(const Vec3& u, const Vec3& v) {
  Vec3 out;
  out.x() = u.dot(v);
  out.tail<2>() = u.x() * v.tail<2>() + v.x() * u.tail<2>();
  return out;
}

Vec3 cone_divide(const Vec3& nu, const Vec3& r) {
  Vec3 out;
  out.x() = (nu.x() * r.x() - nu.tail<2>().dot(r.tail<2>())) / hyperbolic_norm(nu);
  out.tail<2>() = (r.tail<2>() - out.x() * nu.tail<2>()) / nu.x();
  return out;
}

double cone_step(const Vec3& u, const Vec3& d, double limit) {
  // (u + s d)^T J (u + s d) = c + 2 b s + a s^2, c > 0: the smallest positive root ends the step.
  const double a = hyperbolic_norm(d), b = u.x() * d.x() - u.tail<2>().dot(d.tail<2>()),
               c = hyperbolic_norm(u);
  const double discriminant = b * b - a * c;
  double step = limit;
  if (discriminant >= 0) {
    const double q = b >= 0 ? -(b + std::sqrt(discriminant)) : -b + std::sqrt(discriminant);
    for (double root : {a != 0 ? q / a : -1.0, q != 0 ? c / q : -1.0}) {
      if (root > 0) step = std::min(step, root);
    }
  }
  // The other nappe can't be reached without crossing a root, except through the apex.
  if (d.x() < 0) step = std::min(step, -u.x() / d.x());
  return step;
}

ConeScaling cone_scaling(const Vec3& z, const Vec3& lambda) {
  const double nz = hyperbolic_norm(z), nl = hyperbolic_norm(lambda);
  const Vec3 zs = z / std::sqrt(nz), ls = lambda / std::sqrt(nl);
  const double gamma = std::sqrt(0.5 * (1 + zs.dot(ls)));
  const Vec3 w = (zs + reflect(ls)) / (2 * gamma);
  Vec3 v = w;
  v.x() += 1;
  v /= std::sqrt(2 * (w.x() + 1));
  const double beta = std::sqrt(std::sqrt(nz / nl));
  const Eigen::Matrix3d J = Vec3(1, -1, -1).asDiagonal();
  ConeScaling out;
  out.W = beta * (2 * v * v.transpose() - J);
  const Vec3 jv = reflect(v);
  out.W_inverse = (2 * jv * jv.transpose() - J) / beta;
  out.W_squared = beta * beta * (2 * w * w.transpose() - J);
  // (I + 2 t t^T)^-1 = I - 2 t t^T / (1 + 2 |t|^2), split along t and across it.
  const Vec2 t = w.tail<2>();
  out.tangential.setIdentity();
  if (t.squaredNorm() > 0) {
    const Vec2 along = t.normalized(), across = left_of(along);
    out.tangential =
        across * across.transpose() + along * along.transpose() / (1 + 2 * t.squaredNorm());
  }
  out.tangential *= beta * beta;
  out.nu = out.W * lambda;
  return out;
}

}  // namespace curveups
