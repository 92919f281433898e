// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/cone_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

using Eigen::Matrix3d;
using Eigen::VectorXd;

constexpr int max_iterations = 100;

// Unknowns: s, and f, three per point: the force less its floor, (n - s, t) or (n - floor, t).
// (With the force itself the relaxed program loses all digits at the end.) Balance: A f + a s + b =
// 0, a = A applied to a unit normal force at every point, or 0. Cones, with slack z and multiplier
// l:
//   circle: z = (mu (f_n + floor + rho s), f_t); rho is 1, relaxed 0, of friction -weight / mu
//   floor:  z = f_n
//   cap:    z = 1 - s
class ConeProgram {
 public:
  ConeProgram(ForceMap& system, const VectorXd& b, const ConeOptions& options)
      : system_(system),
        count_(system.point_count()),
        b_(b),
        mu_(options.friction_coefficient),
        floor_(options.weight.size() > 0 ? options.floor : 0),
        rho_(VectorXd::Constant(count_, options.relaxed ? 0 : 1)),
        tolerance_(options.tolerance) {
    VectorXd normals = VectorXd::Zero(3 * count_);
    for (int p = 0; p < count_; ++p) normals(3 * p) = 1;
    a_ = system_.apply(normals);
    if (options.weight.size() == 0) return;
    rho_ = -options.weight / mu_;
    b_ += floor_ * a_;
    a_.setZero();
    lifts_ = false;
  }

  ConeSolution solve(const VectorXd& start, const Progress& progress);

 private:
  struct Cones {
    Points3 circle;
    VectorXd floor;
    double cap;
  };
  struct Direction {
    VectorXd f, y;
    double s;
    Cones z, l;
  };

  // circle_of: of forces; circle_by: of their changes.
  Vec3 circle_by(int p, const Vec3& f, double s) const {
    return {mu_ * (f.x() + rho_(p) * s), f.y(), f.z()};
  }
  Vec3 circle_of(int p, double s) const {
    return circle_by(p, f_.segment<3>(3 * p), s) + Vec3(mu_ * floor_, 0, 0);
  }

  void initialize(const VectorXd& start);
  void residuals();
  bool factorize();
  Direction newton(double keep, const Cones& d) const;
  Cones scaled(const Cones& d) const;  // W d
  double step_length(const Direction& d, double limit) const;
  double complementarity() const;
  double complementarity(const Direction& d, double step) const;
  bool converged(double gap) const;
  Cones predictor() const;
  void correct(Cones& d, const Direction& affine, double target) const;
  void advance(const Direction& step, double length);
  void take_up_imbalance();

  ForceMap& system_;
  int count_;
  VectorXd b_;
  double mu_;
  double floor_;
  VectorXd rho_;       // what of s is in the radius of a circle, over mu
  bool lifts_ = true;  // s is the floor
  double tolerance_;
  VectorXd a_;

  VectorXd f_, y_;
  double s_ = 0;
  Cones z_, l_;
  // Residuals: dual (f and s), balance, cones.
  VectorXd r_f_, r_y_;
  double r_s_ = 0;
  Cones r_z_;
  // Scalings and the condensed system: D f + e s + A^T y, e^T f + alpha s + a^T y
  std::vector<ConeScaling> circle_;
  VectorXd w_floor_;
  double w_cap_ = 1;
  std::vector<Matrix3d> D_inverse_;
  Points3 D_e0_, D_e_;  // D^-1 e0, D^-1 e
  double pivot_ = 1;
  VectorXd c_, y_c_;  // c = A D^-1 e - a
};

VectorXd times(const std::vector<Matrix3d>& blocks, const VectorXd& x) {
  VectorXd out(x.size());
  for (std::size_t p = 0; p < blocks.size(); ++p)
    out.segment<3>(3 * p) = blocks[p] * x.segment<3>(3 * p);
  return out;
}

void ConeProgram::initialize(const VectorXd& start) {
  f_ = start;
  y_ = VectorXd::Zero(system_.rows());
  double least = 0;
  for (int p = 0; p < count_; ++p) least = std::min(least, f_(3 * p));
  s_ = lifts_ ? least - 0.1 : 0.0;
  for (int p = 0; p < count_; ++p) {
    f_(3 * p) = lifts_ ? f_(3 * p) - s_ : std::max(0.1, f_(3 * p) - floor_);
  }
  const double weight = 1.0 / std::max(1, count_);
  z_.circle.setZero(count_, 3);
  l_.circle.setZero(count_, 3);
  z_.floor.resize(count_);
  l_.floor = VectorXd::Constant(count_, weight);
  for (int p = 0; p < count_; ++p) {
    z_.floor(p) = f_(3 * p);
    Vec3 u = circle_of(p, s_);
    u.x() = std::max(u.x(), 1.1 * u.tail<2>().norm() + 0.1);
    z_.circle.row(p) = u.transpose();
    l_.circle(p, 0) = weight;
  }
  z_.cap = 1 - s_;
  l_.cap = weight;
}

void ConeProgram::residuals() {
  r_f_ = system_.apply_transposed(y_);
  r_s_ = -1 + l_.cap + a_.dot(y_);
  r_z_.floor.resize(count_);
  r_z_.circle.resize(count_, 3);
  for (int p = 0; p < count_; ++p) {
    r_f_(3 * p) -= l_.floor(p);
    r_z_.floor(p) = z_.floor(p) - f_(3 * p);
    const Vec3 l = l_.circle.row(p);
    r_f_.segment<3>(3 * p) -= Vec3(mu_ * l.x(), l.y(), l.z());
    r_s_ -= mu_ * rho_(p) * l.x();
    r_z_.circle.row(p) = z_.circle.row(p) - circle_of(p, s_).transpose();
  }
  r_z_.cap = z_.cap - (1 - s_);
  r_y_ = system_.apply(f_) + s_ * a_ + b_;
}

bool ConeProgram::factorize() {
  w_floor_ = l_.floor.cwiseQuotient(z_.floor);
  w_cap_ = l_.cap / z_.cap;
  circle_.resize(count_);
  D_inverse_.resize(count_);
  D_e0_.setZero(count_, 3);
  D_e_.setZero(count_, 3);
  pivot_ = w_cap_;
  for (int p = 0; p < count_; ++p) {
    const double w = w_floor_(p);
    // D = M + w e0 e0^T with M^-1 = N from the scaling, e = rho M e0. Sums of positive terms only:
    // near the cones' surfaces D and M have no digits left to invert or subtract.
    circle_[p] = cone_scaling(z_.circle.row(p), l_.circle.row(p));
    Vec3 column = circle_[p].W_squared.col(0) / mu_;
    column.x() /= mu_;
    const double denominator = 1 + w * column.x();
    D_e0_.row(p) = column.transpose() / denominator;
    Matrix3d& D = D_inverse_[p];
    D.col(0) = column / denominator;
    D.row(0) = column.transpose() / denominator;
    D.bottomRightCorner<2, 2>() = circle_[p].tangential + column.tail<2>() *
                                                              column.tail<2>().transpose() /
                                                              (column.x() * denominator);
    D_e_.row(p) = rho_(p) / denominator * Vec3(1, -w * column.y(), -w * column.z()).transpose();
    pivot_ += rho_(p) * rho_(p) * w / denominator;
  }
  if (!system_.factorize(D_inverse_)) return false;
  c_ = system_.apply(Eigen::Map<const VectorXd>(D_e_.data(), D_e_.size())) - a_;
  y_c_ = system_.solve(c_);
  pivot_ += c_.dot(y_c_);
  return std::isfinite(pivot_) && pivot_ > 0;
}

ConeProgram::Cones ConeProgram::scaled(const Cones& d) const {
  Cones out = d;
  for (std::size_t p = 0; p < circle_.size(); ++p) {
    out.circle.row(p) = (circle_[p].W * d.circle.row(p).transpose()).transpose();
  }
  out.floor = d.floor.cwiseQuotient(w_floor_.cwiseSqrt());
  out.cap = d.cap / std::sqrt(w_cap_);
  return out;
}

// Residuals to be reduced to 1 - keep of themselves; d: W dl + W^-1 dz of every cone.
ConeProgram::Direction ConeProgram::newton(double keep, const Cones& d) const {
  // G dx - W^2 dl = beta with G x = -(the cones' linear maps).
  Cones beta = scaled(d);
  beta.floor = -keep * r_z_.floor - beta.floor;
  beta.cap = -keep * r_z_.cap - beta.cap;
  beta.circle = -keep * r_z_.circle - beta.circle;
  VectorXd rhs = -keep * r_f_;
  double rhs_s = -keep * r_s_ + w_cap_ * beta.cap;
  for (int p = 0; p < count_; ++p) {
    rhs(3 * p) -= w_floor_(p) * beta.floor(p);
  }
  const Eigen::Map<const VectorXd> D_e(D_e_.data(), D_e_.size());
  VectorXd D_r = times(D_inverse_, rhs);
  rhs_s -= D_e.dot(rhs);
  for (int p = 0; p < count_; ++p) {
    // The circles' share M beta of the right-hand side, with M cancelled.
    Vec3 b = beta.circle.row(p);
    b.x() /= mu_;
    const double w = w_floor_(p);
    D_r.segment<3>(3 * p) -= b - w * b.x() * D_e0_.row(p).transpose();
    rhs_s -= w * b.x() * D_e_(p, 0);
  }
  Direction out;
  const VectorXd y_r = system_.solve(system_.apply(D_r) + keep * r_y_);
  out.s = (rhs_s + c_.dot(y_r)) / pivot_;
  out.y = y_r - out.s * y_c_;
  out.f = D_r - out.s * D_e - times(D_inverse_, system_.apply_transposed(out.y));
  const VectorXd dual = keep * r_f_ + system_.apply_transposed(out.y);
  out.z.floor.resize(count_);
  out.l.floor.resize(count_);
  out.z.circle.resize(count_, 3);
  out.l.circle.resize(count_, 3);
  for (int p = 0; p < count_; ++p) {
    const double n = out.f(3 * p);
    out.z.floor(p) = -keep * r_z_.floor(p) + n;
    out.l.floor(p) = w_floor_(p) * (-n - beta.floor(p));
    const Vec3 m = circle_by(p, out.f.segment<3>(3 * p), out.s);
    out.z.circle.row(p) = -keep * r_z_.circle.row(p) + m.transpose();
    // From the dual equation rather than from the scaling, which would amplify rounding in f.
    out.l.circle.row(p) << (dual(3 * p) - out.l.floor(p)) / mu_, dual(3 * p + 1), dual(3 * p + 2);
  }
  out.z.cap = -keep * r_z_.cap - out.s;
  out.l.cap = w_cap_ * (out.s - beta.cap);
  return out;
}

double ConeProgram::step_length(const Direction& d, double limit) const {
  double step = limit;
  auto line = [&](double u, double du) {
    if (du < 0) step = std::min(step, -u / du);
  };
  line(z_.cap, d.z.cap);
  line(l_.cap, d.l.cap);
  for (int p = 0; p < count_; ++p) {
    line(z_.floor(p), d.z.floor(p));
    line(l_.floor(p), d.l.floor(p));
    step = cone_step(z_.circle.row(p), d.z.circle.row(p), step);
    step = cone_step(l_.circle.row(p), d.l.circle.row(p), step);
  }
  return step;
}

double ConeProgram::complementarity() const {
  return z_.floor.dot(l_.floor) + z_.cap * l_.cap + z_.circle.cwiseProduct(l_.circle).sum();
}

double ConeProgram::complementarity(const Direction& d, double step) const {
  return (z_.floor + step * d.z.floor).dot(l_.floor + step * d.l.floor) +
         (z_.cap + step * d.z.cap) * (l_.cap + step * d.l.cap) +
         (z_.circle + step * d.z.circle).cwiseProduct(l_.circle + step * d.l.circle).sum();
}

bool ConeProgram::converged(double gap) const {
  double primal = r_z_.floor.size() ? r_z_.floor.cwiseAbs().maxCoeff() : 0;
  if (r_y_.size()) primal = std::max(primal, r_y_.cwiseAbs().maxCoeff());
  if (r_z_.circle.size()) primal = std::max(primal, r_z_.circle.cwiseAbs().maxCoeff());
  // Dual residuals count by what they move the objective.
  const double dual = std::abs(r_s_) + r_f_.cwiseAbs().dot(f_.cwiseAbs());
  return gap < tolerance_ && primal < std::max(1e-6, 0.1 * tolerance_) && dual < tolerance_;
}

// Straight to complementarity zero.
ConeProgram::Cones ConeProgram::predictor() const {
  Cones d;
  d.floor = -(z_.floor.cwiseProduct(l_.floor)).cwiseSqrt();
  d.cap = -std::sqrt(z_.cap * l_.cap);
  d.circle.resize(count_, 3);
  for (std::size_t p = 0; p < circle_.size(); ++p) d.circle.row(p) = -circle_[p].nu.transpose();
  return d;
}

// From the predictor's d: to complementarity `target`, with second-order terms of the step that the
// predictor gave.
void ConeProgram::correct(Cones& d, const Direction& affine, double target) const {
  for (int p = 0; p < count_; ++p) {
    const double nu = -d.floor(p);
    d.floor(p) = (-nu * nu - affine.z.floor(p) * affine.l.floor(p) + target) / nu;
    const ConeScaling& scaling = circle_[p];
    const Vec3 r = -cone_product(scaling.nu, scaling.nu) -
                   cone_product(scaling.W_inverse * affine.z.circle.row(p).transpose(),
                                scaling.W * affine.l.circle.row(p).transpose()) +
                   Vec3(target, 0, 0);
    d.circle.row(p) = cone_divide(scaling.nu, r).transpose();
  }
  const double nu = -d.cap;
  d.cap = (-nu * nu - affine.z.cap * affine.l.cap + target) / nu;
}

void ConeProgram::advance(const Direction& step, double length) {
  f_ += length * step.f;
  y_ += length * step.y;
  s_ += length * step.s;
  z_.floor += length * step.z.floor;
  z_.circle += length * step.z.circle;
  z_.cap += length * step.z.cap;
  l_.floor += length * step.l.floor;
  l_.circle += length * step.l.circle;
  l_.cap += length * step.l.cap;
}

// Where the cones leave most room.
void ConeProgram::take_up_imbalance() {
  for (int round = 0; round < 2 && !D_inverse_.empty(); ++round) {
    const VectorXd rest = system_.apply(f_) + s_ * a_ + b_;
    f_ -= times(D_inverse_, system_.apply_transposed(system_.solve(rest)));
  }
}

ConeSolution ConeProgram::solve(const VectorXd& start, const Progress& progress) {
  initialize(start);
  ConeSolution out;
  const double degree = count_ * 2.0 + 1;
  for (; out.solve.iterations < max_iterations; ++out.solve.iterations) {
    if (!keep_going(progress, "friction and unilateral contacts")) throw Cancelled();
    residuals();
    const double gap = complementarity();
    if (!std::isfinite(gap)) return out;
    if (converged(gap)) {
      out.solve.status = SolveStatus::converged;
      break;
    }
    if (!factorize()) return out;
    Cones d = predictor();
    const Direction affine = newton(1, d);
    const double reached = step_length(affine, 1.0);
    const double ratio = std::clamp(complementarity(affine, reached) / gap, 0.0, 1.0);
    const double centring = ratio * ratio * ratio;
    correct(d, affine, centring * gap / degree);
    const Direction step = newton(1 - centring, d);
    const double length = std::min(1.0, 0.98 * step_length(step, 2.0));
    if (!(length > 1e-10)) return out;
    advance(step, length);
  }
  if (out.solve.converged()) take_up_imbalance();
  out.force = f_;
  for (int p = 0; p < count_; ++p) out.force(3 * p) += lifts_ ? s_ : floor_;
  out.s = s_;
  out.y = y_;
  out.circle = l_.circle;
  out.floor = l_.floor;
  out.weight = l_.floor;
  for (int p = 0; p < count_; ++p) out.weight(p) += mu_ * l_.circle(p, 0);
  return out;
}

}  // namespace

ConeSolution solve_cone_program(ForceMap& map, const VectorXd& b, const VectorXd& start,
                                const ConeOptions& options, const Progress& progress) {
  return ConeProgram(map, b, options).solve(start, progress);
}

}  // namespace curveups
