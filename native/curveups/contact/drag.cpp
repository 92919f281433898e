// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/drag.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"

namespace curveups {

Drag::Drag(std::vector<Pair> pairs, const Poses& from, double lever, double lone)
    : pairs_(std::move(pairs)), lone_(lone) {
  half_.reserve(pairs_.size());
  for (const auto& [body, coupling] : pairs_) {
    half_.push_back((from[body[1]].t - from[body[0]].t) / (2 * lever));
  }
}

Drag::Relative Drag::relative(int pair, const Motions& motions) const {
  const auto& [a, b] = pairs_[pair].body;
  const Relative of_a = motions.row(a).transpose(), of_b = motions.row(b).transpose();
  Relative out = of_a - of_b;
  out.head<3>() += Vec3(of_a.tail<3>() + of_b.tail<3>()).cross(half_[pair]);
  return out;
}

double Drag::furthest_apart(const Motions& motions) const {
  double most = 0;
  for (int k = 0; k < static_cast<int>(pairs_.size()); ++k) {
    const Relative apart = relative(k, motions);
    most = std::max({most, apart.head<3>().squaredNorm(), apart.tail<3>().squaredNorm()});
  }
  return std::sqrt(most);
}

double Drag::value(const Motions& motions, double weight) const {
  const double pairs = parallel_sum(static_cast<int>(pairs_.size()),
                                    [&](int k) { return relative(k, motions).squaredNorm(); });
  return 0.5 * weight * (pairs + lone_ * motions.squaredNorm());
}

double Drag::derivatives(const Motions& motions, double weight, Motions& gradient,
                         BlockMatrix<6>* hessian) const {
  gradient += weight * lone_ * motions;
  double sum = lone_ * motions.squaredNorm();
  parallel_gather<MotionDerivatives<2>>(
      static_cast<int>(pairs_.size()),
      [&](int k, MotionDerivatives<2>& out) {
        const Relative apart = relative(k, motions);
        Eigen::Matrix<double, 6, 12> J;
        J.leftCols<6>().setIdentity();
        J.rightCols<6>() = -J.leftCols<6>();
        J.block<3, 3>(0, 3) = J.block<3, 3>(0, 9) = -skew(half_[k]);
        out.value = apart.squaredNorm();
        out.gradient = weight * J.transpose() * apart;
        if (hessian) out.hessian = weight * J.transpose() * J;
      },
      [&](int k, const MotionDerivatives<2>& out) {
        sum += out.value;
        out.add_to(pairs_[k].body, gradient, hessian, pairs_[k].coupling);
      });
  return 0.5 * weight * sum;
}

}  // namespace curveups
