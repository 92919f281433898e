// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/cone_method.hpp"

#include <algorithm>
#include <cmath>

namespace curveups {
namespace {

constexpr double to_boundary = 0.98;  // share of the way to the cones' boundary that a step goes
constexpr double least_length = 1e-10;

// u^T J u without cancellation near the boundary.
double hyperbolic_norm(const Vec3& u) {
  const double t = u.tail<2>().norm();
  return (u.x() - t) * (u.x() + t);
}

Vec3 reflect(const Vec3& u) { return {u.x(), -u.y(), -u.z()}; }

// Jordan product.
Vec3 product(const Vec3& u, const Vec3& v) {
  Vec3 out;
  out.x() = u.dot(v);
  out.tail<2>() = u.x() * v.tail<2>() + v.x() * u.tail<2>();
  return out;
}

// The d whose Jordan product with nu is r.
Vec3 quotient(const Vec3& r, const Vec3& nu) {
  Vec3 out;
  out.x() = (nu.x() * r.x() - nu.tail<2>().dot(r.tail<2>())) / hyperbolic_norm(nu);
  out.tail<2>() = (r.tail<2>() - out.x() * nu.tail<2>()) / nu.x();
  return out;
}

double longest_step(const ConePoint& at, const ConePoint& d, double limit) {
  for (Eigen::Index k = 0; k < at.line.size(); ++k) {
    if (d.line(k) < 0) limit = std::min(limit, -at.line(k) / d.line(k));
  }
  for (Eigen::Index p = 0; p < at.cone.rows(); ++p) {
    limit = cone_step(at.cone.row(p), d.cone.row(p), limit);
  }
  return limit;
}

// Complementarity after a step of this length.
double complementarity(const ConeProblem& at, const ConeStep& d, double length) {
  return ((at.slack.line + length * d.slack.line) *
          (at.multiplier.line + length * d.multiplier.line))
             .sum() +
         (at.slack.cone + length * d.slack.cone)
             .cwiseProduct(at.multiplier.cone + length * d.multiplier.cone)
             .sum();
}

void move(ConePoint& at, const ConePoint& d, double length) {
  at.line += length * d.line;
  at.cone += length * d.cone;
}

// Shift of the step whose products of complementary values are mu, less the second-order terms of
// the affine step.
ConePoint shift_to(const ConeProblem& at, const std::vector<ConeScaling>& scalings,
                   const ConeStep& affine, double mu) {
  ConePoint out = at.slack;
  out.line = (mu - affine.slack.line * affine.multiplier.line) / at.multiplier.line - at.slack.line;
  for (std::size_t k = 0; k < scalings.size(); ++k) {
    const ConeScaling& s = scalings[k];
    const Eigen::Index p = static_cast<Eigen::Index>(k);
    const Vec3 right = Vec3(mu, 0, 0) - product(s.nu, s.nu) -
                       product(s.W_inverse * affine.slack.cone.row(p).transpose(),
                               s.W * affine.multiplier.cone.row(p).transpose());
    out.cone.row(p) = (s.W * quotient(right, s.nu)).transpose();
  }
  return out;
}

}  // namespace

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

ConeScaling cone_scaling(const Vec3& z, const Vec3& l) {
  const double nz = hyperbolic_norm(z), nl = hyperbolic_norm(l);
  const Vec3 zs = z / std::sqrt(nz), ls = l / std::sqrt(nl);
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
  out.nu = out.W * l;
  return out;
}

SolveReport solve_cone_problem(ConeProblem& at, int max_iterations) {
  SolveReport report;
  const double degree = static_cast<double>(at.slack.line.size() + at.slack.cone.rows());
  std::vector<ConeScaling> scalings(at.slack.cone.rows());
  for (; report.iterations < max_iterations; ++report.iterations) {
    const double gap = at.slack.line.matrix().dot(at.multiplier.line.matrix()) +
                       at.slack.cone.cwiseProduct(at.multiplier.cone).sum();
    if (at.converged(gap)) {
      report.status = SolveStatus::converged;
      return report;
    }
    if (!std::isfinite(gap)) return report;
    for (std::size_t k = 0; k < scalings.size(); ++k) {
      const Eigen::Index p = static_cast<Eigen::Index>(k);
      scalings[k] = cone_scaling(at.slack.cone.row(p), at.multiplier.cone.row(p));
    }
    if (!at.factorize(scalings)) return report;
    // The affine step: W^2 dl + dz = -z, to complementarity zero.
    const ConeStep affine = at.newton({-at.slack.line, -at.slack.cone});
    double length =
        longest_step(at.multiplier, affine.multiplier, longest_step(at.slack, affine.slack, 1));
    const double ratio = std::clamp(complementarity(at, affine, length) / gap, 0.0, 1.0);
    const double centring = ratio * ratio * ratio;
    const ConeStep step = at.newton(shift_to(at, scalings, affine, centring * gap / degree));
    length = std::min(1.0, to_boundary * longest_step(at.multiplier, step.multiplier,
                                                      longest_step(at.slack, step.slack, 2)));
    if (!(length > least_length)) return report;
    at.advance(length);
    move(at.slack, step.slack, length);
    move(at.multiplier, step.multiplier, length);
  }
  return report;
}

}  // namespace curveups
