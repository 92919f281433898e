// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 14: matching front corners of a contact are near one another.
//   E_p = L^-4 sum_k |v_k11 - v_k22|^4 + |v_k12 - v_k21|^4
// as the squares of the vectors |d| d, which keep the curvature that scalars |d|^2 would lose.
#include <cmath>
#include <utility>

#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

class PackingEnergy : public LayoutTerm {
 public:
  explicit PackingEnergy(const LayoutModel& model)
      : model_(model), weight_(std::sqrt(w_p) / (model.L * model.L)) {}

  std::string_view name() const override { return "packing"; }
  int element_count() const override { return static_cast<int>(contacts().size()); }
  int dimension() const override { return 4; }
  int curvature_rows() const override { return 4; }
  Blocks blocks(int block) const override { return contacts()[block].tile; }

  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const Contact& contact = contacts()[block];
    const auto& a = model_.tiles[contact.tile[0]].corner[0];
    const auto& b = model_.tiles[contact.tile[1]].corner[0];
    const PlacedTile ta(x[0]), tb(x[1]);
    const int t = contact.side[0], u = contact.side[1];
    if (derivatives) {
      out.jacobian[0].setZero();
      out.jacobian[1].setZero();
    }
    for (int e = 0; e < 2; ++e) {
      const PlacedPoint p(ta, a[e == 0 ? t : next3(t)]), q(tb, b[e == 0 ? next3(u) : u]);
      const Vec2 d = p.position - q.position;
      const double length = d.norm();
      out.value.segment<2>(2 * e) = weight_ * length * d;
      if (!derivatives) continue;
      Eigen::Matrix2d by_d = length * Eigen::Matrix2d::Identity();
      if (length > 0) by_d += d * d.transpose() / length;
      by_d *= weight_;
      // |d|^4 / 2 has the Hessian 2 |d|^2 I + 4 d d^T, by_d^2 is |d|^2 I + 3 d d^T: the rest.
      Eigen::Matrix2d rest = length * Eigen::Matrix2d::Identity();
      if (length > 0) rest += (std::sqrt(2.0) - 1) * d * d.transpose() / length;
      rest *= weight_;
      for (const auto& [row, by] : {std::pair(2 * e, by_d), std::pair(4 + 2 * e, rest)}) {
        out.jacobian[0].block<2, 2>(row, 0) = by;
        out.jacobian[0].block<2, 1>(row, 2) = by * p.by_angle;
        out.jacobian[1].block<2, 2>(row, 0) = -by;
        out.jacobian[1].block<2, 1>(row, 2) = -by * q.by_angle;
      }
    }
  }

 private:
  const std::vector<Contact>& contacts() const { return model_.geometry->tiles.contacts; }
  const LayoutModel& model_;
  double weight_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_packing_energy(const LayoutModel& model) {
  return std::make_unique<PackingEnergy>(model);
}

}  // namespace curveups
