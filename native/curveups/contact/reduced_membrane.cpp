// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/reduced_membrane.hpp"

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

double twice_area(const std::array<Vec2, 3>& p) { return wedge(p[1] - p[0], p[2] - p[0]); }

}  // namespace

ReducedMembrane::ReducedMembrane(const MembraneDomain& domain, const Points2& flat,
                                 const Points3& corners, double tau,
                                 const MembraneMaterial& material, int first_node)
    : material_(material), tau_(tau) {
  for (const MembranePatch& patch : domain.patches) {
    const std::vector<int>& c = patch.corners;
    const int n = static_cast<int>(c.size());
    if (patch.contact >= 0) {
      Element element{{c[0] / 3, -1, -1}, {}};
      std::array<int, 4> slot{};
      for (int k = 0; k < 4; ++k) {
        if (c[k] / 3 != element.body[0]) element.body[1] = c[k] / 3;
        slot[k] = c[k] / 3 == element.body[0] ? 0 : 1;
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
          add({slot[t[0]], slot[t[1]], slot[t[2]]},
              {corners.row(c[t[0]]), corners.row(c[t[1]]), corners.row(c[t[2]])},
              {flat.row(c[t[0]]), flat.row(c[t[1]]), flat.row(c[t[2]])}, share[d] / sum, element);
        }
      }
      elements_.push_back(std::move(element));
      continue;
    }
    const int node = first_node + static_cast<int>(polygons_.size());
    polygons_.push_back(c);
    Vec2 middle = Vec2::Zero();
    for (int corner : c) middle += flat.row(corner).transpose() / n;
    for (int k = 0; k < n; ++k) {
      const int a = c[k], b = c[(k + 1) % n];
      if (!(twice_area({middle, flat.row(a), flat.row(b)}) > 0)) continue;
      Element element{{node, a / 3, b / 3}, {}};
      add({0, 1, 2}, {Vec3::Zero(), corners.row(a), corners.row(b)},
          {middle, flat.row(a), flat.row(b)}, 1, element);
      elements_.push_back(std::move(element));
    }
  }
}

void ReducedMembrane::add(const std::array<int, 3>& slot, const std::array<Vec3, 3>& point,
                          const std::array<Vec2, 3>& flat, double share, Element& element) const {
  Eigen::Matrix2d rest;
  rest << flat[1] - flat[0], flat[2] - flat[0];
  rest /= tau_;
  element.triangles.push_back(
      {slot, point, rest.inverse(),
       0.5 * material_.shear_modulus * material_.thickness * 0.5 * rest.determinant() * share});
}

void ReducedMembrane::couple(std::vector<Coupling>& couplings) const {
  for (const Element& element : elements_) {
    const auto& [a, b, c] = element.body;
    couplings.insert(couplings.end(), {{a, b}, {a, c}, {b, c}});
  }
}

double ReducedMembrane::evaluate(const Element& element, const Poses& poses, double lever,
                                 bool second, MotionDerivatives<3>* out) const {
  double sum = 0;
  for (const Triangle& t : element.triangles) {
    const Eigen::Matrix2d inverse = stretch * t.inverse;
    const double weight = pull / (stretch * stretch) * t.weight;
    std::array<Vec3, 3> x;
    for (int k = 0; k < 3; ++k) x[k] = poses[element.body[t.slot[k]]](t.point[k]);
    // F's columns are sums of the corners with these coefficients.
    Eigen::Matrix<double, 3, 2> coefficient;
    coefficient.bottomRows<2>() = inverse;
    coefficient.row(0) = -inverse.colwise().sum();
    Gradient32 F = Gradient32::Zero();
    for (int k = 0; k < 3; ++k) F += x[k] * coefficient.row(k);
    const Density density = material_.model->evaluate(F, material_.constants, second);
    sum += weight * density.value;
    if (!out) continue;
    // By the motion of corner k the gradient of F is (I, turn_k), times its two coefficients.
    std::array<Eigen::Matrix3d, 3> turn;
    for (int k = 0; k < 3; ++k) {
      const RigidMotion& pose = poses[element.body[t.slot[k]]];
      const Vec3 arm = pose.R * t.point[k];
      turn[k] = skew(arm / -lever);
      const Vec3 force = weight * (coefficient(k, 0) * density.gradient.head<3>() +
                                   coefficient(k, 1) * density.gradient.tail<3>());
      const int at = 6 * t.slot[k];
      out->gradient.segment<3>(at) += force;
      out->gradient.segment<3>(at + 3) += turn[k].transpose() * force;
      if (!second) continue;
      const Eigen::Matrix3d turns = turn_curvature(force, arm, lever);
      out->hessian.block<3, 3>(at + 3, at + 3) += convex ? positive_part(turns) : turns;
    }
    if (!second) continue;
    for (int k = 0; k < 3; ++k) {
      for (int l = k; l < 3; ++l) {
        const Eigen::Matrix3d moves =
            weight *
            (coefficient(k, 0) * coefficient(l, 0) * density.hessian.topLeftCorner<3, 3>() +
             coefficient(k, 0) * coefficient(l, 1) * density.hessian.topRightCorner<3, 3>() +
             coefficient(k, 1) * coefficient(l, 0) * density.hessian.bottomLeftCorner<3, 3>() +
             coefficient(k, 1) * coefficient(l, 1) * density.hessian.bottomRightCorner<3, 3>());
        const Eigen::Matrix3d turned = moves * turn[l];
        Eigen::Matrix<double, 6, 6> block;
        block << moves, turned, turn[k].transpose() * moves, turn[k].transpose() * turned;
        const int row = 6 * t.slot[k], column = 6 * t.slot[l];
        out->hessian.block<6, 6>(row, column) += block;
        if (l != k) out->hessian.block<6, 6>(column, row) += block.transpose();
      }
    }
  }
  if (out) out->value = sum;
  return sum;
}

double ReducedMembrane::value(const Poses& poses) const {
  return parallel_sum(static_cast<int>(elements_.size()),
                      [&](int k) { return evaluate(elements_[k], poses, 1, false, nullptr); });
}

double ReducedMembrane::derivatives(const Poses& poses, double lever, Motions& gradient,
                                    BlockMatrix<6>* hessian, int first) const {
  double sum = 0;
  parallel_gather<MotionDerivatives<3>>(
      static_cast<int>(elements_.size()),
      [&](int k, MotionDerivatives<3>& out) {
        out = {};
        evaluate(elements_[k], poses, lever, hessian != nullptr, &out);
      },
      [&](int k, const MotionDerivatives<3>& out) {
        sum += out.value;
        out.add_to(elements_[k].body, gradient, hessian, first + 3 * k);
      });
  return sum;
}

}  // namespace curveups
