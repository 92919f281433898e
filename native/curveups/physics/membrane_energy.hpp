// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic energy of one membrane: constant-strain triangles (paper, A.1), energy = h A psi with h
// the rest thickness and A the rest area. Rest shape = flat / tau.
#pragma once

#include <vector>

#include "curveups/numerics/sparse_cholesky.hpp"
#include "curveups/physics/density.hpp"
#include "curveups/physics/membrane_mesh.hpp"

namespace curveups {

struct MembraneMaterial {
  double shear_modulus = 0.72;  // MPa
  double thickness = 0.5;       // at rest, mm
  MembraneModel model = MembraneModel::tension_field;
  double regularization = 1e-4;  // of the tension-field density
};

// Per triangle, for pictures and verdicts.
struct TriangleStretch {
  double larger, smaller;  // principal stretches (not squared)
  MembraneTension tension;
};

// The unknowns are the vertices that no pin holds, three numbers each, in an order that suits the
// Hessian's factorization (Ordering::as_given).
class MembraneEnergy {
 public:
  // flat: per mesh vertex. Throws InvalidInput for a modulus, thickness or tau that is not
  // positive.
  MembraneEnergy(const MembraneMesh& mesh, const Points2& flat, double tau,
                 const MembraneMaterial& material);

  int free_count() const { return free_count_; }
  // Per mesh vertex its place among the free ones, or -1.
  const std::vector<int>& free_index() const { return free_index_; }
  // kappa h: half the shear modulus times the rest thickness, N / mm.
  double stiffness() const { return stiffness_; }

  // N mm. Infinite where a triangle of the plain density has no area.
  double value(const Points3& x) const;
  // Gradient for every mesh vertex, glued ones too: the pull on a pin is minus its gradient.
  double gradient(const Points3& x, Points3& gradient) const;
  // Lower triangle over the free unknowns; the pattern never changes. `projected`: the nearest
  // positive semidefinite matrix in each triangle.
  double hessian(const Points3& x, Points3& gradient, SparseMatrix& lower, bool projected) const;
  // A sweep of Jacobi's method: per free vertex minus the inverse of its own block of the Hessian
  // times its gradient; zero for glued ones. Returns the energy at x.
  double jacobi_direction(const Points3& x, Points3& gradient, Points3& direction) const;
  // Scalar Laplacian over the free vertices and the harmonic positions it gives to them, glued ones
  // fixed: the minimum of sum A |F|^2.
  Points3 harmonic(const Points3& glued) const;

  std::vector<TriangleStretch> stretches(const Points3& x) const;

  // Another rest shape of the same mesh. Throws InvalidInput where a triangle turns over.
  void set_rest(const Points2& flat, double tau);
  // Second derivatives along displacements of all vertices, glued ones too: per displacement w the
  // derivative of w . dE/dx by the actuated positions and, where `by_flat` is not null, by the flat
  // ones. Sums over triangles in their order.
  void second_derivatives(const Points3& x, const std::vector<Points3>& displacements,
                          std::vector<Points3>& by_position, std::vector<Points2>* by_flat) const;

 private:
  struct Element {
    std::array<int, 3> vertex;
    Eigen::Matrix2d inverse;  // of the rest edge matrix: F = (x1 - x0, x2 - x0) inverse
    double weight;            // rest area, mm2
    // For the pairs 0-1, 1-2, 2-0 of free vertices: how far behind the diagonal block the pair's
    // block begins in its columns; -1 where one of them is glued.
    std::array<int, 3> offset;
  };
  Gradient32 deformation(const Element& element, const Points3& x) const;
  Density density(const Gradient32& F, bool second) const;
  std::vector<std::vector<int>> neighbours_above() const;
  void number_free_vertices();
  void make_pattern();

  std::vector<Element> elements_;
  std::vector<int> free_index_;
  int free_count_ = 0;
  double stiffness_;
  double tau_ = 1;
  MembraneMaterial material_;
  SparseMatrix pattern_;
};

}  // namespace curveups
