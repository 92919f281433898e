// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/cone_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/numerics/cone_method.hpp"

namespace curveups {
namespace {

using Eigen::Matrix3d;
using Eigen::VectorXd;

constexpr int max_iterations = 100;

// Unknowns: s, and f, three per point: the force less its floor, (n - s, t) or (n - floor, t).
// (With the force itself the relaxed program loses all digits at the end.) Balance: A f + a s + b =
// 0, a = A applied to a unit normal force at every point, or 0. Slacks:
//   circle (a cone per point): (mu (f_n + floor + rho s), f_t); rho is 1, relaxed 0, of friction
//                              -1 / mu
//   floor (a half-line per point): f_n
//   cap (the last half-line):      1 - s
class ConeProgram : public ConeProblem {
 public:
  ConeProgram(ForceMap& system, const VectorXd& b, const ConeOptions& options,
              const Progress& progress)
      : system_(system),
        progress_(progress),
        count_(system.point_count()),
        b_(b),
        mu_(options.friction_coefficient),
        floor_(options.friction ? options.floor : 0),
        rho_(VectorXd::Constant(count_, options.relaxed ? 0 : 1)),
        tolerance_(options.tolerance) {
    VectorXd normals = VectorXd::Zero(3 * count_);
    for (int p = 0; p < count_; ++p) normals(3 * p) = 1;
    a_ = system_.apply(normals);
    if (!options.friction) return;
    rho_.setConstant(-1 / mu_);
    b_ += floor_ * a_;
    a_.setZero();
    lifts_ = false;
  }

  ConeSolution solve(const VectorXd& start);

  bool converged(double gap) override;
  bool factorize(const std::vector<ConeScaling>& scalings) override;
  ConeStep newton(const ConePoint& shift) override;
  void advance(double length) override {
    f_ += length * d_f_;
    y_ += length * d_y_;
    s_ += length * d_s_;
  }

 private:
  // Circle's slack, of forces without their floor and of changes of forces.
  Vec3 circle(int p, const VectorXd& f, double s) const {
    return {mu_ * (f(3 * p) + rho_(p) * s), f(3 * p + 1), f(3 * p + 2)};
  }
  // Slacks of the iterate's forces.
  ConePoint slacks() const;
  void initialize(const VectorXd& start);
  void take_up_imbalance();

  ForceMap& system_;
  const Progress& progress_;
  int count_;
  VectorXd b_;
  double mu_, floor_;
  VectorXd rho_;       // s in the radius of a circle, over mu
  bool lifts_ = true;  // s is the floor
  double tolerance_;
  VectorXd a_;

  VectorXd f_, y_, d_f_, d_y_;  // iterate and its last direction
  double s_ = 0, d_s_ = 0;
  // Residuals: dual (f and s), balance, slacks.
  VectorXd r_f_, r_y_;
  double r_s_ = 0;
  ConePoint r_z_;
  // Condensed system: D f + e s + A^T y, e^T f + alpha s + a^T y
  Eigen::ArrayXd w_;  // l / z of the half-lines
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

ConePoint ConeProgram::slacks() const {
  ConePoint out{Eigen::ArrayXd(count_ + 1), Points3(count_, 3)};
  for (int p = 0; p < count_; ++p) {
    out.line(p) = f_(3 * p);
    out.cone.row(p) = circle(p, f_, s_).transpose();
    out.cone(p, 0) += mu_ * floor_;
  }
  out.line(count_) = 1 - s_;
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
  slack = slacks();
  for (int p = 0; p < count_; ++p) {
    const double tangential = slack.cone.row(p).tail<2>().norm();
    slack.cone(p, 0) = std::max(slack.cone(p, 0), 1.1 * tangential + 0.1);
  }
  const double weight = 1.0 / std::max(1, count_);
  multiplier.line.setConstant(count_ + 1, weight);
  multiplier.cone.setZero(count_, 3);
  multiplier.cone.col(0).setConstant(weight);
}

bool ConeProgram::converged(double gap) {
  if (!keep_going(progress_, "friction and unilateral contacts")) throw Cancelled();
  r_f_ = system_.apply_transposed(y_);
  r_s_ = -1 + multiplier.line(count_) + a_.dot(y_);
  for (int p = 0; p < count_; ++p) {
    const Vec3 l = multiplier.cone.row(p);
    r_f_.segment<3>(3 * p) -= Vec3(mu_ * l.x() + multiplier.line(p), l.y(), l.z());
    r_s_ -= mu_ * rho_(p) * l.x();
  }
  r_z_ = slacks();
  r_z_.line = slack.line - r_z_.line;
  r_z_.cone = slack.cone - r_z_.cone;
  r_y_ = system_.apply(f_) + s_ * a_ + b_;
  const double primal = std::max({r_z_.line.abs().maxCoeff(), r_z_.cone.lpNorm<Eigen::Infinity>(),
                                  r_y_.lpNorm<Eigen::Infinity>()});
  // Dual residuals count by what they move the objective.
  const double dual = std::abs(r_s_) + r_f_.cwiseAbs().dot(f_.cwiseAbs());
  return gap < tolerance_ && primal < std::max(1e-6, 0.1 * tolerance_) && dual < tolerance_;
}

bool ConeProgram::factorize(const std::vector<ConeScaling>& scalings) {
  w_ = multiplier.line / slack.line;
  D_inverse_.resize(count_);
  D_e0_.setZero(count_, 3);
  D_e_.setZero(count_, 3);
  pivot_ = w_(count_);
  for (int p = 0; p < count_; ++p) {
    const double w = w_(p);
    // D = M + w e0 e0^T with M^-1 = N from the scaling, e = rho M e0. Sums of positive terms only:
    // near the cones' surfaces D and M have no digits left to invert or subtract.
    Vec3 column = scalings[p].W_squared.col(0) / mu_;
    column.x() /= mu_;
    const double denominator = 1 + w * column.x();
    D_e0_.row(p) = column.transpose() / denominator;
    Matrix3d& D = D_inverse_[p];
    D.col(0) = column / denominator;
    D.row(0) = column.transpose() / denominator;
    D.bottomRightCorner<2, 2>() = scalings[p].tangential + column.tail<2>() *
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

ConeStep ConeProgram::newton(const ConePoint& shift) {
  // G dx - W^2 dl = beta with G x = -(the slacks' linear maps).
  const Eigen::ArrayXd beta = -r_z_.line - shift.line;
  const Points3 beta_circle = -r_z_.cone - shift.cone;
  VectorXd rhs = -r_f_;
  for (int p = 0; p < count_; ++p) rhs(3 * p) -= w_(p) * beta(p);
  const Eigen::Map<const VectorXd> D_e(D_e_.data(), D_e_.size());
  double rhs_s = -r_s_ + w_(count_) * beta(count_) - D_e.dot(rhs);
  VectorXd D_r = times(D_inverse_, rhs);
  for (int p = 0; p < count_; ++p) {
    // The circles' share M beta of the right-hand side, with M cancelled.
    Vec3 b = beta_circle.row(p);
    b.x() /= mu_;
    D_r.segment<3>(3 * p) -= b - w_(p) * b.x() * D_e0_.row(p).transpose();
    rhs_s -= w_(p) * b.x() * D_e_(p, 0);
  }
  const VectorXd y_r = system_.solve(system_.apply(D_r) + r_y_);
  d_s_ = (rhs_s + c_.dot(y_r)) / pivot_;
  d_y_ = y_r - d_s_ * y_c_;
  const VectorXd pull = system_.apply_transposed(d_y_);
  d_f_ = D_r - d_s_ * D_e - times(D_inverse_, pull);
  const VectorXd dual = r_f_ + pull;
  ConeStep out{{-r_z_.line, -r_z_.cone}, {beta, Points3(count_, 3)}};
  for (int p = 0; p < count_; ++p) {
    out.slack.line(p) += d_f_(3 * p);
    out.slack.cone.row(p) += circle(p, d_f_, d_s_).transpose();
    out.multiplier.line(p) = -w_(p) * (d_f_(3 * p) + beta(p));
    // From the dual equation rather than from the scaling, which would amplify rounding in f.
    out.multiplier.cone.row(p) << (dual(3 * p) - out.multiplier.line(p)) / mu_, dual(3 * p + 1),
        dual(3 * p + 2);
  }
  out.slack.line(count_) -= d_s_;
  out.multiplier.line(count_) = w_(count_) * (d_s_ - beta(count_));
  return out;
}

// Lets forces where the cones leave most room take the rest of balance.
void ConeProgram::take_up_imbalance() {
  for (int round = 0; round < 2 && !D_inverse_.empty(); ++round) {
    const VectorXd rest = system_.apply(f_) + s_ * a_ + b_;
    f_ -= times(D_inverse_, system_.apply_transposed(system_.solve(rest)));
  }
}

ConeSolution ConeProgram::solve(const VectorXd& start) {
  initialize(start);
  ConeSolution out;
  out.solve = solve_cone_problem(*this, max_iterations);
  if (out.solve.converged()) take_up_imbalance();
  out.force = f_;
  for (int p = 0; p < count_; ++p) out.force(3 * p) += lifts_ ? s_ : floor_;
  out.s = s_;
  out.y = y_;
  out.circle = multiplier.cone;
  out.floor = multiplier.line.head(count_);
  out.weight = out.floor + mu_ * multiplier.cone.col(0);
  return out;
}

}  // namespace

ConeSolution solve_cone_program(ForceMap& map, const VectorXd& b, const VectorXd& start,
                                const ConeOptions& options, const Progress& progress) {
  return ConeProgram(map, b, options, progress).solve(start);
}

}  // namespace curveups
