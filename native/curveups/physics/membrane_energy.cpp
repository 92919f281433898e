// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_energy.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// b_v with F = sum of x_v b_v^T over the three vertices.
std::array<Eigen::Vector2d, 3> shape_gradients(const Eigen::Matrix2d& inverse) {
  const Eigen::Vector2d b1 = inverse.row(0), b2 = inverse.row(1);
  return {-b1 - b2, b1, b2};
}

// Gradient of a triangle's energy by its vertex with shape gradient b.
Vec3 pull(double factor, const Eigen::Vector2d& b, const Vector6& stress) {
  return factor * (b.x() * stress.head<3>() + b.y() * stress.tail<3>());
}

// Second derivatives of a triangle's energy by one vertex.
Eigen::Matrix3d vertex_block(const Matrix6& hessian, const Eigen::Vector2d& b) {
  const Eigen::Matrix3d mixed = hessian.topRightCorner<3, 3>();
  return b.x() * b.x() * hessian.topLeftCorner<3, 3>() +
         b.x() * b.y() * (mixed + mixed.transpose()) +
         b.y() * b.y() * hessian.bottomRightCorner<3, 3>();
}

// Second derivatives by two vertices, the first of them in the rows.
Eigen::Matrix3d pair_block(const Matrix6& hessian, const Eigen::Vector2d& row,
                           const Eigen::Vector2d& column) {
  const Eigen::Matrix3d h11 = hessian.topLeftCorner<3, 3>(), h12 = hessian.topRightCorner<3, 3>(),
                        h22 = hessian.bottomRightCorner<3, 3>();
  return row.x() * column.x() * h11 + row.x() * column.y() * h12 +
         row.y() * column.x() * h12.transpose() + row.y() * column.y() * h22;
}

// Share of a triangle: by its vertices, and by the pairs 0-1, 1-2, 2-0 of them.
struct TriangleDerivatives {
  double value;
  std::array<Vec3, 3> pull;
  std::array<Eigen::Matrix3d, 3> own, pair;
};

}  // namespace

MembraneEnergy::MembraneEnergy(const MembraneMesh& mesh, const Points2& flat, double tau,
                               const MembraneMaterial& material)
    : stiffness_(0.5 * material.shear_modulus * material.thickness), material_(material) {
  elements_.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    elements_.push_back({t, Eigen::Matrix2d::Zero(), 0});
  }
  set_rest(flat, tau);
  std::vector<char> free;
  for (int pin : mesh.pin) free.push_back(pin < 0);
  std::vector<Coupling> couplings;
  couple(couplings);
  pattern_ = std::make_shared<const BlockPattern>(free, couplings);
}

void MembraneEnergy::couple(std::vector<Coupling>& couplings) const {
  for (const Element& e : elements_) {
    for (int k = 0; k < 3; ++k) couplings.push_back({e.vertex[k], e.vertex[next3(k)]});
  }
}

void MembraneEnergy::set_rest(const Points2& flat, double tau) {
  tau_ = tau;
  for (Element& e : elements_) {
    Eigen::Matrix2d edges;
    edges.col(0) = (flat.row(e.vertex[1]) - flat.row(e.vertex[0])).transpose() / tau;
    edges.col(1) = (flat.row(e.vertex[2]) - flat.row(e.vertex[0])).transpose() / tau;
    const double doubled = edges.determinant();
    if (!(doubled > 0)) {
      throw InvalidInput("a membrane triangle has no area in the layout", "mesh the layout again");
    }
    e.inverse = edges.inverse();
    e.weight = 0.5 * doubled;
  }
}

void MembraneEnergy::second_derivatives(const Points3& x, const std::vector<Points3>& displacements,
                                        std::vector<Points3>& by_position,
                                        std::vector<Points2>* by_flat) const {
  const std::size_t count = displacements.size();
  by_position.assign(count, Points3::Zero(x.rows(), 3));
  if (by_flat) by_flat->assign(count, Points2::Zero(x.rows(), 2));
  struct Change {
    std::array<Vec3, 3> pull;
    Eigen::Matrix2d by_edges;
  };
  auto make = [&](int index, std::vector<Change>& changes) {
    const Element& e = elements_[index];
    const Gradient32 F = deformation(e, x);
    const Density d = density(F, true);
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    const double factor = stiffness_ * e.weight;
    changes.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Gradient32 dF = deformation(e, displacements[k]);
      const Vector6 dP = d.hessian * Eigen::Map<const Vector6>(dF.data());
      for (int v = 0; v < 3; ++v) changes[k].pull[v] = pull(factor, b[v], dP);
      if (!by_flat) continue;
      // w . dE/dx = factor P : dF; by the rest edges R (F = edges R^-1, weight = det R / 2) this is
      // factor ((P : dF) - dF^T P - F^T dP) R^-T, all applied from the left of R^-T.
      const Eigen::Map<const Gradient32> P(d.gradient.data()), H(dP.data());
      changes[k].by_edges = factor *
                            (P.cwiseProduct(dF).sum() * Eigen::Matrix2d::Identity() -
                             dF.transpose() * P - F.transpose() * H) *
                            e.inverse.transpose() / tau_;
    }
  };
  auto take = [&](int index, const std::vector<Change>& changes) {
    const std::array<int, 3>& vertex = elements_[index].vertex;
    for (std::size_t k = 0; k < count; ++k) {
      for (int v = 0; v < 3; ++v) by_position[k].row(vertex[v]) += changes[k].pull[v].transpose();
      if (!by_flat) continue;
      const Eigen::Matrix2d& by_edges = changes[k].by_edges;
      Points2& out = (*by_flat)[k];
      out.row(vertex[0]) -= (by_edges.col(0) + by_edges.col(1)).transpose();
      out.row(vertex[1]) += by_edges.col(0).transpose();
      out.row(vertex[2]) += by_edges.col(1).transpose();
    }
  };
  parallel_gather<std::vector<Change>>(element_count(), make, take);
}

Gradient32 MembraneEnergy::deformation(const Element& element, const Points3& x) const {
  Gradient32 edges;
  edges.col(0) = (x.row(element.vertex[1]) - x.row(element.vertex[0])).transpose();
  edges.col(1) = (x.row(element.vertex[2]) - x.row(element.vertex[0])).transpose();
  return edges * element.inverse;
}

Density MembraneEnergy::density(const Gradient32& F, bool second) const {
  return material_.model->evaluate(F, material_.regularization, second);
}

double MembraneEnergy::value(const Points3& x) const {
  return stiffness_ * parallel_sum(element_count(), [&](int index) {
           const Element& e = elements_[index];
           return e.weight * density(deformation(e, x), false).value;
         });
}

double MembraneEnergy::gradient(const Points3& x, Points3& gradient,
                                BlockMatrix<3>* hessian) const {
  gradient.setZero(x.rows(), 3);
  if (hessian) hessian->set_zero();
  return derivatives(x, gradient, hessian, 0);
}

double MembraneEnergy::derivatives(const Points3& x, Points3& gradient, BlockMatrix<3>* hessian,
                                   int first) const {
  auto make = [&](int index, TriangleDerivatives& out) {
    const Element& e = elements_[index];
    const Density d = density(deformation(e, x), hessian != nullptr);
    const double factor = stiffness_ * e.weight;
    out.value = e.weight * d.value;
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    for (int k = 0; k < 3; ++k) out.pull[k] = pull(factor, b[k], d.gradient);
    if (!hessian) return;
    for (int k = 0; k < 3; ++k) {
      if (is_free(e.vertex[k])) out.own[k] = factor * vertex_block(d.hessian, b[k]);
      const BlockSlot& slot = hessian->pattern().slot(first + 3 * index + k);
      if (!slot.stored()) continue;
      const int n = next3(k);
      out.pair[k] = factor * (slot.swapped ? pair_block(d.hessian, b[n], b[k])
                                           : pair_block(d.hessian, b[k], b[n]));
    }
  };
  double sum = 0;
  auto take = [&](int index, const TriangleDerivatives& triangle) {
    const Element& e = elements_[index];
    sum += triangle.value;
    for (int k = 0; k < 3; ++k) {
      gradient.row(e.vertex[k]) += triangle.pull[k].transpose();
      if (!hessian) continue;
      const BlockPattern& pattern = hessian->pattern();
      if (is_free(e.vertex[k])) hessian->add(pattern.diagonal(e.vertex[k]), triangle.own[k]);
      const BlockSlot& slot = pattern.slot(first + 3 * index + k);
      if (slot.stored()) hessian->add(slot, triangle.pair[k]);
    }
  };
  parallel_gather<TriangleDerivatives>(element_count(), make, take);
  return stiffness_ * sum;
}

std::vector<TriangleStretch> MembraneEnergy::stretches(const Points3& x) const {
  std::vector<TriangleStretch> out(elements_.size());
  parallel_for(element_count(), [&](int e) {
    const PrincipalStretches l = principal_stretches(deformation(elements_[e], x));
    out[e] = {std::sqrt(l.l1), std::sqrt(l.l2), l.tension()};
  });
  return out;
}

}  // namespace curveups
