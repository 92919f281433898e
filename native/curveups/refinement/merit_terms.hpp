// SPDX-License-Identifier: LGPL-2.1-or-later
// The terms of Eq. 3 that a repair lowers where tightness is a penalty: E_target + w_tight E_tight.
// A new one is a class here, a summand of the repair's merit and its share of the step
// (layout_step.cpp).
#pragma once

#include "curveups/core/types.hpp"
#include "curveups/numerics/term.hpp"

namespace curveups {

// Eq. 4: E_target = sum_j A_j |x_j - c_j|^2 over vertices x, c_j their places in the target (mm),
// A_j the area that belongs to each (mm2). mm4.
class TargetDistance : public Term<3> {
 public:
  TargetDistance(Points3 places, Eigen::VectorXd area)
      : places_(std::move(places)), area_(std::move(area)) {}

  const Points3& places() const { return places_; }
  const Eigen::VectorXd& area() const { return area_; }

  std::string_view name() const override { return "target"; }
  void couple(std::vector<Coupling>&) const override {}
  double value(const BlockVector<3>& x) const override;
  double derivatives(const BlockVector<3>& x, BlockVector<3>& gradient, BlockMatrix<3>* hessian,
                     int first) const override;

 private:
  Points3 places_;
  Eigen::VectorXd area_;
};

// Eq. 5: E_tight = sum_p [goal - f_p]+^2 over normal forces f, one unknown each, in the unit of the
// goal.
class MissingForce : public Term<1> {
 public:
  explicit MissingForce(double goal) : goal_(goal) {}

  std::string_view name() const override { return "tightness"; }
  void couple(std::vector<Coupling>&) const override {}
  double value(const BlockVector<1>& force) const override;
  double derivatives(const BlockVector<1>& force, BlockVector<1>& gradient, BlockMatrix<1>* hessian,
                     int first) const override;

 private:
  double goal_;
};

}  // namespace curveups
