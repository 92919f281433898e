// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 16: the membrane between two facing pins as a spring, rest length over actuated length.
//   E_s = sum_{k,s} ( |pbar_k2 - pbar_k1| / (tau B_ks) )^2
// pbar are the midpoints of the facing pin edges in the flat layout. B is the distance between
// those edges at the pins' tops when actuated: with half the fold h (negated on the back) and the
// insets q1, q2 it is closed form,
//   B^2 = ((q1 + q2) cos h + 2 H_pin sin h)^2 + ((q1 - q2) sin h)^2.
#include <cmath>

#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

// The midpoint of pin edge t and its derivatives by the pose and the three insets of the side.
struct PinMiddle {
  PinMiddle(const LayoutTile& tile, const PlacedTile& placed, Side side, int t) {
    const auto& corner = tile.corner[static_cast<int>(side)];
    const int u = next3(t), v = prev3(t);
    const double* q = placed.insets + inset_index(side, 0);
    // Corner t moves with insets v and t, corner u with t and u.
    by_inset[v] = 0.5 * tile.per_previous[t];
    by_inset[t] = 0.5 * (tile.per_own[t] + tile.per_previous[u]);
    by_inset[u] = 0.5 * tile.per_own[u];
    const Vec2 local = 0.5 * (corner[t] + corner[u]) + q[v] * by_inset[v] + q[t] * by_inset[t] +
                       q[u] * by_inset[u];
    const PlacedPoint point(placed, local);
    position = point.position;
    by_angle = point.by_angle;
    for (Vec2& d : by_inset) d = placed.turn * d;
  }
  Vec2 position, by_angle;
  std::array<Vec2, 3> by_inset;
};

class SpringEnergy : public LayoutTerm {
 public:
  explicit SpringEnergy(const LayoutModel& model)
      : model_(model), weight_(std::sqrt(w_s) / model.parameters.tau) {}

  std::string_view name() const override { return "spring"; }
  int element_count() const override { return 2 * static_cast<int>(contacts().size()); }
  int dimension() const override { return 2; }
  int curvature_rows() const override { return 1; }
  Blocks blocks(int block) const override { return contacts()[block / 2].tile; }

  void evaluate(int block, const Unknowns& x, bool derivatives, Value& out) const override {
    const Contact& contact = contacts()[block / 2];
    const Side side = block % 2 == 0 ? Side::front : Side::back;
    const int i = contact.tile[0], t = contact.side[0], j = contact.tile[1], u = contact.side[1];
    const PlacedTile placed_i(x[0]), placed_j(x[1]);
    const PinMiddle p(model_.tiles[i], placed_i, side, t), q(model_.tiles[j], placed_j, side, u);
    const double dihedral = model_.geometry->tiles.dihedral(i, t);
    const double half = side == Side::front ? 0.5 * dihedral : -0.5 * dihedral;
    const auto [distance, by_q1, by_q2] = spring_length(
        x[0][inset_unknown(side, t)], x[1][inset_unknown(side, u)], half, model_.parameters.H_pin);
    const Vec2 a = q.position - p.position;
    const double factor = weight_ / distance;
    out.value.head<2>() = factor * a;
    if (!derivatives) return;
    out.jacobian[0].setZero();
    out.jacobian[1].setZero();
    out.jacobian[0].block<2, 2>(0, 0) = -factor * Eigen::Matrix2d::Identity();
    out.jacobian[1].block<2, 2>(0, 0) = factor * Eigen::Matrix2d::Identity();
    out.jacobian[0].block<2, 1>(0, 2) = -factor * p.by_angle;
    out.jacobian[1].block<2, 1>(0, 2) = factor * q.by_angle;
    for (int k = 0; k < 3; ++k) {
      out.jacobian[0].block<2, 1>(0, inset_unknown(side, k)) = -factor * p.by_inset[k];
      out.jacobian[1].block<2, 1>(0, inset_unknown(side, k)) = factor * q.by_inset[k];
    }
    // a^2 / (2 B^2) curves by 3 a^2 / B^4 along B, of which first derivatives see a third.
    const double rest = std::sqrt(2.0) * factor * a.norm() / distance;
    out.jacobian[0](2, inset_unknown(side, t)) = rest * by_q1;
    out.jacobian[1](2, inset_unknown(side, u)) = rest * by_q2;
    out.jacobian[0].block<2, 1>(0, inset_unknown(side, t)) -= factor * by_q1 / distance * a;
    out.jacobian[1].block<2, 1>(0, inset_unknown(side, u)) -= factor * by_q2 / distance * a;
  }

 private:
  const std::vector<Contact>& contacts() const { return model_.geometry->tiles.contacts; }
  const LayoutModel& model_;
  double weight_;
};

}  // namespace

std::unique_ptr<LayoutTerm> make_spring_energy(const LayoutModel& model) {
  return std::make_unique<SpringEnergy>(model);
}

}  // namespace curveups
