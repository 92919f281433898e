// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 6: a pin's area. Insets scale the triangle down about a point: with face edges l_t shifted
// inwards by delta_t the area is A (1 - sum (delta_t + q_t) l_t / (2 A))^2, so that the hard
// constraint is linear,
//   1 - sum (delta_t + q_t) l_t / (2 A) >= sqrt(A_min / A),
// times L, in mm. As the energy of Eq. 12:
//   E_pa = L^-4 sum [2 A_min - 2 A_pin]+^2.
#include <cmath>

#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

class PinAreaFunction : public LayoutTerm {
 public:
  explicit PinAreaFunction(const LayoutModel& model) : model_(model) {}
  int element_count() const override { return 2 * model_.tile_count(); }
  int dimension() const override { return 1; }
  Blocks blocks(int block) const override { return {block / 2, -1}; }

 protected:
  struct Scale {
    double value;  // linear scale of the pin against the front triangle
    double least;  // what it must be
    Vec3 by_inset;
  };
  Scale scale(int block, const double* unknowns) const {
    const LayoutTile& tile = model_.tiles[block / 2];
    const Side side = block % 2 == 0 ? Side::front : Side::back;
    Scale out{1 - tile.shift[block % 2] / (2 * tile.area), 0, Vec3::Zero()};
    for (int t = 0; t < 3; ++t) {
      out.by_inset(t) = -tile.length[t] / (2 * tile.area);
      out.value += out.by_inset(t) * unknowns[inset_unknown(side, t)];
    }
    out.least = std::sqrt(model_.geometry->pin_bounds.least_area(block / 2, block % 2) / tile.area);
    return out;
  }
  static void fill(int block, const Vec3& by_inset, Value& out) {
    out.jacobian[0].row(0).setZero();
    out.jacobian[0].block<1, 3>(0, block % 2 == 0 ? 3 : 6) = by_inset.transpose();
  }
  const LayoutModel& model_;
};

class PinAreaConstraint : public PinAreaFunction {
 public:
  using PinAreaFunction::PinAreaFunction;
  std::string_view name() const override { return "pin area"; }
  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const Scale s = scale(block, x[0]);
    out.value(0) = model_.L * (s.value - s.least);
    if (derivatives) fill(block, model_.L * s.by_inset, out);
  }
};

class PinAreaEnergy : public PinAreaFunction {
 public:
  explicit PinAreaEnergy(const LayoutModel& model)
      : PinAreaFunction(model), weight_(std::sqrt(model.parameters.w_pa) / (model.L * model.L)) {}
  std::string_view name() const override { return "pin area"; }
  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const Scale s = scale(block, x[0]);
    const double area = model_.tiles[block / 2].area;
    // A pin that has turned over has a negative area.
    const double missing = 2 * area * (s.least * s.least - s.value * std::abs(s.value));
    const double factor = missing > 0 ? weight_ : 0.0;
    out.value(0) = factor * missing;
    if (derivatives) fill(block, -factor * 4 * area * std::abs(s.value) * s.by_inset, out);
  }

 private:
  double weight_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_pin_area_constraint(const LayoutModel& model) {
  return std::make_unique<PinAreaConstraint>(model);
}

std::unique_ptr<LayoutTerm> make_pin_area_energy(const LayoutModel& model) {
  return std::make_unique<PinAreaEnergy>(model);
}

}  // namespace curveups
