// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 13: the two diagonals of a gap are equal, so that facing edges stand opposite one another.
//   E_a = L^-2 sum_k (|v_k11 - v_k21| - |v_k12 - v_k22|)^2, front corners.
#include <cmath>

#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

class AlignmentEnergy : public LayoutTerm {
 public:
  explicit AlignmentEnergy(const LayoutModel& model)
      : model_(model), weight_(std::sqrt(w_a) / model.L) {}

  std::string_view name() const override { return "alignment"; }
  int element_count() const override { return static_cast<int>(contacts().size()); }
  int dimension() const override { return 1; }
  Blocks blocks(int block) const override { return contacts()[block].tile; }

  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const Contact& contact = contacts()[block];
    const auto& a = model_.tiles[contact.tile[0]].corner[0];
    const auto& b = model_.tiles[contact.tile[1]].corner[0];
    const PlacedTile ta(x[0]), tb(x[1]);
    const int t = contact.side[0], u = contact.side[1];
    const PlacedPoint v11(ta, a[t]), v12(ta, a[next3(t)]), v21(tb, b[u]), v22(tb, b[next3(u)]);
    const Vec2 d1 = v11.position - v21.position, d2 = v12.position - v22.position;
    // Lengths smoothed below a micrometre, where their derivative has no direction.
    const double l1 = std::sqrt(d1.squaredNorm() + 1e-6), l2 = std::sqrt(d2.squaredNorm() + 1e-6);
    out.value(0) = weight_ * (l1 - l2);
    if (!derivatives) return;
    const Vec2 g1 = weight_ / l1 * d1, g2 = weight_ / l2 * d2;
    out.jacobian[0].row(0) << (g1 - g2).transpose(), g1.dot(v11.by_angle) - g2.dot(v12.by_angle), 0,
        0, 0, 0, 0, 0;
    out.jacobian[1].row(0) << (g2 - g1).transpose(), g2.dot(v22.by_angle) - g1.dot(v21.by_angle), 0,
        0, 0, 0, 0, 0;
  }

 private:
  const std::vector<Contact>& contacts() const { return model_.geometry->tiles.contacts; }
  const LayoutModel& model_;
  double weight_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_alignment_energy(const LayoutModel& model) {
  return std::make_unique<AlignmentEnergy>(model);
}

}  // namespace curveups
