// SPDX-License-Identifier: LGPL-2.1-or-later
// Pin corners stay clear of truncation planes: linear in two insets (PinKeepout).
#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

class PinKeepoutConstraint : public LayoutTerm {
 public:
  explicit PinKeepoutConstraint(const LayoutModel& model)
      : keepouts_(model.geometry->pin_bounds.keepouts) {}

  std::string_view name() const override { return "pin keep-out"; }
  int element_count() const override { return static_cast<int>(keepouts_.size()); }
  int dimension() const override { return 1; }
  Blocks blocks(int block) const override { return {keepouts_[block].tile, -1}; }

  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const PinKeepout& keepout = keepouts_[block];
    const int previous = inset_unknown(keepout.side, prev3(keepout.corner));
    const int own = inset_unknown(keepout.side, keepout.corner);
    out.value(0) = keepout.a_prev * x[0][previous] + keepout.a_here * x[0][own] - keepout.bound;
    if (!derivatives) return;
    out.jacobian[0].row(0).setZero();
    out.jacobian[0](0, previous) = keepout.a_prev;
    out.jacobian[0](0, own) = keepout.a_here;
  }

 private:
  const std::vector<PinKeepout>& keepouts_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_pin_keepout_constraint(const LayoutModel& model) {
  return std::make_unique<PinKeepoutConstraint>(model);
}

}  // namespace curveups
