// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/merit_terms.hpp"

#include <algorithm>

namespace curveups {

double TargetDistance::value(const BlockVector<3>& x) const {
  return area_.dot((x - places_).rowwise().squaredNorm());
}

double TargetDistance::derivatives(const BlockVector<3>& x, BlockVector<3>& gradient,
                                   BlockMatrix<3>* hessian, int) const {
  gradient += 2 * area_.asDiagonal() * (x - places_);
  for (int j = 0; hessian && j < x.rows(); ++j) {
    if (hessian->pattern().rank(j) < 0) continue;
    for (int c = 0; c < 3; ++c) hessian->diagonal(j, c) += 2 * area_(j);
  }
  return value(x);
}

double MissingForce::value(const BlockVector<1>& force) const {
  return (goal_ - force.array()).max(0.0).square().sum();
}

double MissingForce::derivatives(const BlockVector<1>& force, BlockVector<1>& gradient,
                                 BlockMatrix<1>* hessian, int) const {
  gradient.array() -= 2 * (goal_ - force.array()).max(0.0);
  for (int p = 0; hessian && p < force.rows(); ++p) {
    if (force(p) < goal_ && hessian->pattern().rank(p) >= 0) hessian->diagonal(p, 0) += 2;
  }
  return value(force);
}

}  // namespace curveups
