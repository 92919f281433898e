// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic energy of one membrane: constant-strain triangles (paper, A.1), energy = h A psi with h
// the rest thickness and A the rest area. Rest shape = flat / tau.
#pragma once

#include <vector>

#include "curveups/numerics/block_matrix.hpp"
#include "curveups/physics/density.hpp"
#include "curveups/physics/membrane_mesh.hpp"

namespace curveups {

struct MembraneMaterial {
  double shear_modulus = 0.72;  // MPa
  double thickness = 0.5;       // at rest, mm
  const DensityModel* model = &density_model("tension-field");
  double regularization = 1e-4;  // DensityModel::evaluate
};

// Per triangle, for pictures and verdicts.
struct TriangleStretch {
  double larger, smaller;  // principal stretches (not squared)
  MembraneTension tension;
};

// Energy of a membrane, N mm: a block per mesh vertex, unknown where no pin holds it; an element
// per triangle, with its exact Hessian.
class MembraneEnergy {
 public:
  // flat: per mesh vertex. Throws what set_rest throws.
  MembraneEnergy(const MembraneMesh& mesh, const Points2& flat, double tau,
                 const MembraneMaterial& material);

  // Pattern of the Hessian.
  const std::shared_ptr<const BlockPattern>& pattern() const { return pattern_; }
  bool is_free(int vertex) const { return pattern_->rank(vertex) >= 0; }
  int free_count() const { return pattern_->free_count(); }

  // Appends the pairs of vertices that triangles join. derivatives() fills their slots.
  void couple(std::vector<Coupling>& couplings) const;
  // Infinite where a triangle of the plain density has no area.
  double value(const Points3& x) const;
  // Adds to the gradient and, unless null, to the Hessian, whose pattern has the first coupling as
  // number `first`. The gradient has a row for every mesh vertex, glued ones too, where it is minus
  // the pull on the pin. Returns the value.
  double derivatives(const Points3& x, Points3& gradient, BlockMatrix<3>* hessian, int first) const;
  // Set the gradient and, unless null, the Hessian (of this pattern).
  double gradient(const Points3& x, Points3& gradient, BlockMatrix<3>* hessian = nullptr) const;

  std::vector<TriangleStretch> stretches(const Points3& x) const;
  // Replace the rest shape. Throws InvalidInput where a triangle turns over.
  void set_rest(const Points2& flat, double tau);
  // Second derivatives along displacements of all vertices, glued ones too: per displacement w the
  // derivative of w . dE/dx by the actuated positions and, where `by_flat` is not null, by the flat
  // ones. Sums over triangles in their order.
  void second_derivatives(const Points3& x, const std::vector<Points3>& displacements,
                          std::vector<Points3>& by_position, std::vector<Points2>* by_flat) const;

 private:
  struct Element {
    std::array<int, 3> vertex;
    Eigen::Matrix2d inverse;  // rest edge matrix, inverted: F = (x1 - x0, x2 - x0) inverse
    double weight;            // rest area, mm2
  };
  Gradient32 deformation(const Element& element, const Points3& x) const;
  Density density(const Gradient32& F, bool second) const;
  int element_count() const { return static_cast<int>(elements_.size()); }

  std::vector<Element> elements_;
  std::shared_ptr<const BlockPattern> pattern_;
  double stiffness_ = 0;  // kappa h: half the shear modulus times the rest thickness, N / mm
  double tau_ = 1;
  MembraneMaterial material_;
};

}  // namespace curveups
