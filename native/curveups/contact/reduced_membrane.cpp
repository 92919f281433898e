// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/reduced_membrane.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

Vec2 middle_of(const std::vector<int>& polygon, const Points2& flat) {
  Vec2 middle = Vec2::Zero();
  for (int corner : polygon) {
    middle += flat.row(corner).transpose() / static_cast<double>(polygon.size());
  }
  return middle;
}

double twice_area(const std::array<Vec2, 3>& p) { return wedge(p[1] - p[0], p[2] - p[0]); }

}  // namespace

ReducedMembrane::ReducedMembrane(const MembraneDomain& domain, const Points2& flat,
                                 const Points3& corners, double tau,
                                 const MembraneMaterial& material, int first_node)
    : material_(material), tau_(tau) {
  int node = first_node;
  for (const MembranePatch& patch : domain.patches) {
    const std::vector<int>& c = patch.corners;
    const int n = static_cast<int>(c.size());
    if (patch.contact >= 0) {
      Element element{{c[0] / 3, -1, -1}, 4, {}, {}, {}};
      for (int k = 0; k < 4; ++k) {
        if (c[k] / 3 != element.body[0]) element.body[1] = c[k] / 3;
        element.slot[k] = c[k] / 3 == element.body[0] ? 0 : 1;
        element.point[k] = corners.row(c[k]);
      }
      // Along the diagonal from corner 0 and from corner 1; where the flat quadrilateral is not
      // convex only one of them lies inside.
      std::array<double, 2> share{};
      for (int d = 0; d < 2; ++d) {
        const bool inside =
            twice_area({flat.row(c[d]), flat.row(c[d + 1]), flat.row(c[d + 2])}) > 0 &&
            twice_area({flat.row(c[d]), flat.row(c[d + 2]), flat.row(c[(d + 3) % 4])}) > 0;
        share[d] = inside ? 0.5 : 0;
      }
      const double sum = share[0] + share[1];
      for (int d = 0; d < 2 && sum > 0; ++d) {
        for (const std::array<int, 3>& t :
             {std::array<int, 3>{d, d + 1, d + 2}, std::array<int, 3>{d, d + 2, (d + 3) % 4}}) {
          if (share[d] == 0) continue;
          add_triangle(element, t, {flat.row(c[t[0]]), flat.row(c[t[1]]), flat.row(c[t[2]])},
                       share[d] / sum);
        }
      }
      elements_.push_back(std::move(element));
      continue;
    }
    const Vec2 middle = middle_of(c, flat);
    for (int k = 0; k < n; ++k) {
      const int a = c[k], b = c[(k + 1) % n];
      if (!(twice_area({middle, flat.row(a), flat.row(b)}) > 0)) continue;
      Element element{
          {node, a / 3, b / 3}, 3, {0, 1, 2}, {Vec3::Zero(), corners.row(a), corners.row(b)}, {}};
      add_triangle(element, {0, 1, 2}, {middle, flat.row(a), flat.row(b)}, 1);
      elements_.push_back(std::move(element));
    }
    ++node;
  }
}

// Adds a triangle unless it is turned over in the layout.
void ReducedMembrane::add_triangle(Element& element, const std::array<int, 3>& corner,
                                   const std::array<Vec2, 3>& flat, double share) const {
  Eigen::Matrix2d rest;
  rest << flat[1] - flat[0], flat[2] - flat[0];
  rest /= tau_;
  const double twice = rest.determinant();
  if (!(twice > 0)) return;
  element.triangles.push_back(
      {corner, rest.inverse(),
       0.25 * material_.shear_modulus * material_.thickness * twice * share});
}

void ReducedMembrane::couple(std::vector<Coupling>& couplings) const {
  for (const Element& element : elements_) {
    const auto& [a, b, c] = element.body;
    couplings.insert(couplings.end(), {{a, b}, {a, c}, {b, c}});
  }
}

double ReducedMembrane::evaluate(const Element& element, const Poses& poses, double lever,
                                 const MotionHessian* hessian, MotionDerivatives<3>* out) const {
  const bool second = hessian != nullptr;
  const int count = element.corner_count;
  std::array<Vec3, 4> arm, x, force;
  for (int c = 0; c < count; ++c) {
    const RigidMotion& pose = poses[element.body[element.slot[c]]];
    arm[c] = pose.R * element.point[c];
    x[c] = arm[c] + pose.t;
    force[c].setZero();
  }
  // Second derivatives by the corners' coordinates; blocks on and above the diagonal.
  Eigen::Matrix<double, 12, 12> moves;
  if (second) moves.setZero();
  double sum = 0;
  for (const Triangle& t : element.triangles) {
    const double weight = t.weight;
    // F's columns are sums of the edges e1 and e2. The first corner moves both.
    const double a = t.inverse(0, 0), b = t.inverse(0, 1), c = t.inverse(1, 0), d = t.inverse(1, 1);
    const auto& [i, j, k] = t.corner;
    const Vec3 e1 = x[j] - x[i], e2 = x[k] - x[i];
    Gradient32 F;
    F << a * e1 + c * e2, b * e1 + d * e2;
    const Density density = material_.model->evaluate(F, material_.regularization, second);
    sum += weight * density.value;
    if (!out) continue;
    const auto g1 = density.gradient.head<3>(), g2 = density.gradient.tail<3>();
    const Vec3 by_1 = weight * (a * g1 + b * g2), by_2 = weight * (c * g1 + d * g2);
    force[i] -= by_1 + by_2;
    force[j] += by_1;
    force[k] += by_2;
    if (!second) continue;
    const Eigen::Matrix3d h11 = weight * density.hessian.topLeftCorner<3, 3>(),
                          h12 = weight * density.hessian.topRightCorner<3, 3>(),
                          h22 = weight * density.hessian.bottomRightCorner<3, 3>();
    const Eigen::Matrix3d both = h12 + h12.transpose(),
                          by_11 = a * a * h11 + a * b * both + b * b * h22,
                          by_22 = c * c * h11 + c * d * both + d * d * h22,
                          by_12 = a * c * h11 + a * d * h12 + b * c * h12.transpose() + b * d * h22,
                          to_1 = by_11 + by_12.transpose(), to_2 = by_12 + by_22;
    const auto add = [&](int row, int column, const Eigen::Matrix3d& block) {
      if (row <= column) {
        moves.block<3, 3>(3 * row, 3 * column) += block;
      } else {
        moves.block<3, 3>(3 * column, 3 * row) += block.transpose();
      }
    };
    add(i, i, to_1 + to_2);
    add(i, j, -to_1);
    add(i, k, -to_2);
    add(j, j, by_11);
    add(j, k, by_12);
    add(k, k, by_22);
  }
  if (!out) return sum;
  out->value = sum;
  // A corner moves with its body by (I, turn).
  std::array<Eigen::Matrix3d, 4> turn;
  for (int c = 0; c < count; ++c) {
    turn[c] = skew(arm[c] / -lever);
    const int at = 6 * element.slot[c];
    out->gradient.segment<3>(at) += force[c];
    out->gradient.segment<3>(at + 3) += turn[c].transpose() * force[c];
    if (!second) continue;
    out->hessian.block<3, 3>(at + 3, at + 3) +=
        hessian->projected ? positive_turn_curvature(force[c], arm[c], lever)
                           : turn_curvature(force[c], arm[c], lever);
  }
  if (!second) return sum;
  for (int c = 0; c < count; ++c) {
    for (int d = c; d < count; ++d) {
      const Eigen::Matrix3d own = moves.block<3, 3>(3 * c, 3 * d), turned = own * turn[d];
      Eigen::Matrix<double, 6, 6> block;
      block << own, turned, turn[c].transpose() * own, turn[c].transpose() * turned;
      const int row = 6 * element.slot[c], column = 6 * element.slot[d];
      out->hessian.block<6, 6>(row, column) += block;
      if (d != c) out->hessian.block<6, 6>(column, row) += block.transpose();
    }
  }
  return sum;
}

double ReducedMembrane::value(const Poses& poses) const {
  return parallel_sum(static_cast<int>(elements_.size()),
                      [&](int k) { return evaluate(elements_[k], poses, 1, nullptr, nullptr); });
}

double ReducedMembrane::derivatives(const Poses& poses, double lever, Motions& gradient,
                                    const MotionHessian* hessian) const {
  double sum = 0;
  parallel_gather<MotionDerivatives<3>>(
      static_cast<int>(elements_.size()),
      [&](int k, MotionDerivatives<3>& out) {
        out.clear(hessian != nullptr);
        evaluate(elements_[k], poses, lever, hessian, &out);
      },
      [&](int k, const MotionDerivatives<3>& out) {
        sum += out.value;
        out.add_to(elements_[k].body, gradient, hessian, 3 * k);
      });
  return sum;
}

}  // namespace curveups
