// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_energy.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/physics/neo_hookean.hpp"
#include "curveups/physics/tension_field.hpp"

namespace curveups {
namespace {

Matrix6 positive_part(const Matrix6& H) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(H);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

// b_v with F = sum of x_v b_v^T over the three vertices.
std::array<Eigen::Vector2d, 3> shape_gradients(const Eigen::Matrix2d& inverse) {
  const Eigen::Vector2d b1 = inverse.row(0), b2 = inverse.row(1);
  return {-b1 - b2, b1, b2};
}

// What a triangle adds to the gradient by its vertex v with shape gradient b.
void add_pull(Points3& gradient, int v, double factor, const Eigen::Vector2d& b,
              const Vector6& stress) {
  gradient.row(v) += factor * (b.x() * stress.head<3>() + b.y() * stress.tail<3>()).transpose();
}

// Second derivatives by one vertex.
Eigen::Matrix3d vertex_block(const Matrix6& hessian, const Eigen::Vector2d& b) {
  const Eigen::Matrix3d mixed = hessian.topRightCorner<3, 3>();
  return b.x() * b.x() * hessian.topLeftCorner<3, 3>() +
         b.x() * b.y() * (mixed + mixed.transpose()) +
         b.y() * b.y() * hessian.bottomRightCorner<3, 3>();
}

}  // namespace

MembraneEnergy::MembraneEnergy(const MembraneMesh& mesh, const Points2& flat, double tau,
                               const MembraneMaterial& material)
    : stiffness_(0.5 * material.shear_modulus * material.thickness), material_(material) {
  if (!(material.shear_modulus > 0 && material.thickness > 0 && tau > 0 &&
        std::isfinite(stiffness_))) {
    throw InvalidInput("a membrane's shear modulus, thickness and stretch must be positive",
                       "give positive numbers");
  }
  free_index_.assign(mesh.vertex_count(), -1);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.pin[v] < 0) free_index_[v] = free_count_++;
  }
  elements_.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    elements_.push_back({t, Eigen::Matrix2d::Zero(), 0, {-1, -1, -1}});
  }
  set_rest(flat, tau);
  number_free_vertices();
  make_pattern();
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
  for (const Element& e : elements_) {
    const Gradient32 F = deformation(e, x);
    const Density d = density(F, true);
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    const double factor = stiffness_ * e.weight;
    for (std::size_t k = 0; k < count; ++k) {
      const Gradient32 dF = deformation(e, displacements[k]);
      const Vector6 dP = d.hessian * Eigen::Map<const Vector6>(dF.data());
      for (int v = 0; v < 3; ++v) {
        by_position[k].row(e.vertex[v]) +=
            factor * (b[v].x() * dP.head<3>() + b[v].y() * dP.tail<3>()).transpose();
      }
      if (!by_flat) continue;
      // w . dE/dx = factor P : dF; by the rest edges R (F = edges R^-1, weight = det R / 2) this is
      // factor ((P : dF) - dF^T P - F^T dP) R^-T, all applied from the left of R^-T.
      const Eigen::Map<const Gradient32> P(d.gradient.data()), H(dP.data());
      const Eigen::Matrix2d by_edges = factor *
                                       (P.cwiseProduct(dF).sum() * Eigen::Matrix2d::Identity() -
                                        dF.transpose() * P - F.transpose() * H) *
                                       e.inverse.transpose() / tau_;
      Points2& out = (*by_flat)[k];
      out.row(e.vertex[0]) -= (by_edges.col(0) + by_edges.col(1)).transpose();
      out.row(e.vertex[1]) += by_edges.col(0).transpose();
      out.row(e.vertex[2]) += by_edges.col(1).transpose();
    }
  }
}

// Per free vertex its free neighbours of higher number, ascending.
std::vector<std::vector<int>> MembraneEnergy::neighbours_above() const {
  std::vector<std::vector<int>> above(free_count_);
  for (const Element& e : elements_) {
    for (int k = 0; k < 3; ++k) {
      const int a = free_index_[e.vertex[k]], b = free_index_[e.vertex[next3(k)]];
      if (a >= 0 && b >= 0) above[std::min(a, b)].push_back(std::max(a, b));
    }
  }
  for (std::vector<int>& rows : above) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  return above;
}

void MembraneEnergy::number_free_vertices() {
  const std::vector<int> order = elimination_order(neighbours_above());
  std::vector<int> number(free_count_);
  for (int k = 0; k < free_count_; ++k) number[order[k]] = k;
  for (int& index : free_index_) {
    if (index >= 0) index = number[index];
  }
}

void MembraneEnergy::make_pattern() {
  const std::vector<std::vector<int>> above = neighbours_above();
  int entries = 0;
  for (const std::vector<int>& rows : above) entries += 6 + 9 * static_cast<int>(rows.size());
  pattern_.resize(3 * free_count_, 3 * free_count_);
  pattern_.resizeNonZeros(entries);
  int at = 0;
  for (int v = 0; v < free_count_; ++v) {
    for (int c = 0; c < 3; ++c) {
      pattern_.outerIndexPtr()[3 * v + c] = at;
      for (int r = c; r < 3; ++r) pattern_.innerIndexPtr()[at++] = 3 * v + r;
      for (int u : above[v]) {
        for (int r = 0; r < 3; ++r) pattern_.innerIndexPtr()[at++] = 3 * u + r;
      }
    }
  }
  pattern_.outerIndexPtr()[3 * free_count_] = at;
  for (Element& e : elements_) {
    for (int k = 0; k < 3; ++k) {
      const int a = free_index_[e.vertex[k]], b = free_index_[e.vertex[next3(k)]];
      if (a < 0 || b < 0) continue;
      const std::vector<int>& rows = above[std::min(a, b)];
      const auto it = std::lower_bound(rows.begin(), rows.end(), std::max(a, b));
      e.offset[k] = 3 * static_cast<int>(it - rows.begin());
    }
  }
}

Gradient32 MembraneEnergy::deformation(const Element& element, const Points3& x) const {
  Gradient32 edges;
  edges.col(0) = (x.row(element.vertex[1]) - x.row(element.vertex[0])).transpose();
  edges.col(1) = (x.row(element.vertex[2]) - x.row(element.vertex[0])).transpose();
  return edges * element.inverse;
}

Density MembraneEnergy::density(const Gradient32& F, bool second) const {
  return material_.model == MembraneModel::tension_field
             ? tension_field(F, material_.regularization, second)
             : neo_hookean(F, second);
}

double MembraneEnergy::value(const Points3& x) const {
  double sum = 0;
  for (const Element& e : elements_) sum += e.weight * density(deformation(e, x), false).value;
  return stiffness_ * sum;
}

double MembraneEnergy::gradient(const Points3& x, Points3& gradient) const {
  gradient.setZero(x.rows(), 3);
  double sum = 0;
  for (const Element& e : elements_) {
    const Density d = density(deformation(e, x), false);
    sum += e.weight * d.value;
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    for (int v = 0; v < 3; ++v) {
      add_pull(gradient, e.vertex[v], stiffness_ * e.weight, b[v], d.gradient);
    }
  }
  return stiffness_ * sum;
}

double MembraneEnergy::hessian(const Points3& x, Points3& gradient, SparseMatrix& lower,
                               bool projected) const {
  if (lower.nonZeros() != pattern_.nonZeros() || lower.rows() != pattern_.rows()) lower = pattern_;
  double* values = lower.valuePtr();
  std::fill(values, values + lower.nonZeros(), 0.0);
  const int* outer = lower.outerIndexPtr();
  gradient.setZero(x.rows(), 3);
  double sum = 0;
  for (const Element& e : elements_) {
    Density d = density(deformation(e, x), true);
    const double factor = stiffness_ * e.weight;
    sum += e.weight * d.value;
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    for (int v = 0; v < 3; ++v) add_pull(gradient, e.vertex[v], factor, b[v], d.gradient);
    if (projected) d.hessian = positive_part(d.hessian);
    const Eigen::Matrix3d h11 = d.hessian.topLeftCorner<3, 3>(),
                          h12 = d.hessian.topRightCorner<3, 3>(),
                          h22 = d.hessian.bottomRightCorner<3, 3>();
    for (int k = 0; k < 3; ++k) {
      const int a = free_index_[e.vertex[k]];
      if (a < 0) continue;
      const Eigen::Vector2d s = b[k];
      const Eigen::Matrix3d block = factor * vertex_block(d.hessian, s);
      for (int c = 0; c < 3; ++c) {
        for (int r = c; r < 3; ++r) values[outer[3 * a + c] + r - c] += block(r, c);
      }
      if (e.offset[k] < 0) continue;
      const int n = free_index_[e.vertex[next3(k)]];
      const bool forward = n > a;  // rows: the vertex of higher number
      const Eigen::Vector2d row = forward ? b[next3(k)] : s, col = forward ? s : b[next3(k)];
      const Eigen::Matrix3d pair =
          factor * (row.x() * col.x() * h11 + row.x() * col.y() * h12 +
                    row.y() * col.x() * h12.transpose() + row.y() * col.y() * h22);
      const int column = 3 * std::min(a, n);
      for (int c = 0; c < 3; ++c) {
        double* to = values + outer[column + c] + 3 - c + e.offset[k];
        for (int r = 0; r < 3; ++r) to[r] += pair(r, c);
      }
    }
  }
  return stiffness_ * sum;
}

double MembraneEnergy::jacobi_direction(const Points3& x, Points3& gradient,
                                        Points3& direction) const {
  gradient.setZero(x.rows(), 3);
  direction.setZero(x.rows(), 3);
  std::vector<Eigen::Matrix3d> blocks(free_count_, Eigen::Matrix3d::Zero());
  double sum = 0;
  for (const Element& e : elements_) {
    Density d = density(deformation(e, x), true);
    const double factor = stiffness_ * e.weight;
    sum += e.weight * d.value;
    // The other density is convex.
    if (material_.model == MembraneModel::neo_hookean) d.hessian = positive_part(d.hessian);
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    for (int v = 0; v < 3; ++v) {
      add_pull(gradient, e.vertex[v], factor, b[v], d.gradient);
      const int a = free_index_[e.vertex[v]];
      if (a >= 0) blocks[a] += factor * vertex_block(d.hessian, b[v]);
    }
  }
  for (std::size_t v = 0; v < free_index_.size(); ++v) {
    if (free_index_[v] < 0) continue;
    Eigen::Matrix3d& block = blocks[free_index_[v]];
    block.diagonal().array() += 1e-9 * block.trace();
    direction.row(v) = -block.llt().solve(gradient.row(v).transpose()).transpose();
  }
  return stiffness_ * sum;
}

Points3 MembraneEnergy::harmonic(const Points3& glued) const {
  Points3 x = glued;
  if (free_count_ == 0) return x;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * elements_.size());
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(free_count_, 3);
  for (const Element& e : elements_) {
    const std::array<Eigen::Vector2d, 3> b = shape_gradients(e.inverse);
    for (int v = 0; v < 3; ++v) {
      const int row = free_index_[e.vertex[v]];
      if (row < 0) continue;
      for (int u = 0; u < 3; ++u) {
        const double entry = e.weight * b[v].dot(b[u]);
        const int column = free_index_[e.vertex[u]];
        if (column < 0) {
          rhs.row(row) -= entry * glued.row(e.vertex[u]);
        } else if (row >= column) {
          entries.emplace_back(row, column, entry);
        }
      }
    }
  }
  SparseMatrix lower(free_count_, free_count_);
  lower.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky cholesky(Ordering::as_given);
  if (!cholesky.factorize(lower)) {
    throw SolverFailure("the membrane's harmonic start could not be computed",
                        "a part of the membrane hangs on no pin: check cuts and layout");
  }
  const Eigen::MatrixXd solution = cholesky.solve(rhs);
  for (int v = 0; v < static_cast<int>(free_index_.size()); ++v) {
    if (free_index_[v] >= 0) x.row(v) = solution.row(free_index_[v]);
  }
  return x;
}

std::vector<TriangleStretch> MembraneEnergy::stretches(const Points3& x) const {
  std::vector<TriangleStretch> out;
  out.reserve(elements_.size());
  for (const Element& e : elements_) {
    const PrincipalStretches l = principal_stretches(deformation(e, x));
    out.push_back({std::sqrt(l.l1), std::sqrt(l.l2), l.tension()});
  }
  return out;
}

}  // namespace curveups
