// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 6: a pin's area. Insets scale the triangle down about a point: with face edges l_t shifted
// inwards by delta_t the area is A (1 - sum (delta_t + q_t) l_t / (2 A))^2, so that the constraint
// is linear,
//   1 - sum (delta_t + q_t) l_t / (2 A) >= sqrt(A_min / A),
// times L, in mm.
#include <cmath>

#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

class PinAreaConstraint : public LayoutTerm {
 public:
  explicit PinAreaConstraint(const LayoutModel& model) : model_(model) {}

  std::string_view name() const override { return "pin area"; }
  int element_count() const override { return 2 * model_.tile_count(); }
  int dimension() const override { return 1; }
  Blocks blocks(int block) const override { return {block / 2, -1}; }

  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const LayoutTile& tile = model_.tiles[block / 2];
    const Side side = block % 2 == 0 ? Side::front : Side::back;
    double scale = 1 - tile.shift[block % 2] / (2 * tile.area);  // scale of the pin's lengths
    Vec3 by_inset;
    for (int t = 0; t < 3; ++t) {
      by_inset(t) = -tile.length[t] / (2 * tile.area);
      scale += by_inset(t) * x[0][inset_unknown(side, t)];
    }
    const double least =
        std::sqrt(model_.geometry->pin_bounds.least_area(block / 2, block % 2) / tile.area);
    out.value(0) = model_.L * (scale - least);
    if (!derivatives) return;
    out.jacobian[0].row(0).setZero();
    out.jacobian[0].block<1, 3>(0, inset_unknown(side, 0)) = model_.L * by_inset.transpose();
  }

 private:
  const LayoutModel& model_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_pin_area_constraint(const LayoutModel& model) {
  return std::make_unique<PinAreaConstraint>(model);
}

}  // namespace curveups
