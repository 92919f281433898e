// SPDX-License-Identifier: LGPL-2.1-or-later
// Quasi-static equilibrium of one membrane in the actuated configuration: its glued vertices move
// with the pins, the free ones minimise the elastic energy (paper, A.1) by Newton's method.
#pragma once

#include <string>
#include <utility>

#include "curveups/core/progress.hpp"
#include "curveups/numerics/solve_report.hpp"
#include "curveups/physics/membrane_energy.hpp"

namespace curveups {

struct EquilibriumOptions {
  int max_iterations = 200;
  // Damped Jacobi sweeps ahead of Newton's method: what an interpolated start is wrong in varies
  // from vertex to vertex, and each sweep costs a tenth of an iteration.
  int sweeps = 3;
  // Largest force left on a free vertex, relative to the mean force on a glued one.
  double tolerance = 1e-11;
};

struct MembraneState {
  Points3 x;         // all mesh vertices, mm
  Points3 gradient;  // dE / dx there, N; the membrane pulls with minus this on its pins
  double energy = 0;
  // residual: the largest force on a free vertex, relative to the mean on a glued one.
  SolveReport solve;
};

// Owns the Hessian's factorization: after solve() it is that of the last step.
class MembraneEquilibrium {
 public:
  MembraneEquilibrium(const MembraneMesh& mesh, const Points2& flat, double tau,
                      const MembraneMaterial& material)
      : energy_(mesh, flat, tau, material), hessian_(energy_.pattern()) {}

  // start: all vertices, glued ones in their final places. The energy never rises from step to
  // step. Stops early when progress asks to.
  MembraneState solve(const Points3& start, const EquilibriumOptions& options,
                      const Progress& progress = {}, const std::string& what = "membrane");

  // Another rest shape of the same mesh (MembraneEnergy::set_rest); the factorization's ordering
  // stays.
  void set_rest(const Points2& flat, double tau) { energy_.set_rest(flat, tau); }
  // Factorizes the Hessian at x, for respond(). False where it is not finite.
  bool factorize(const Points3& x) {
    Points3 gradient;
    return energy_.free_count() == 0 || factorize(x, gradient);
  }
  // How free vertices follow displacements of glued ones, by the last factorization: fills in the
  // free rows of each displacement. x: the equilibrium.
  void respond(const Points3& x, std::vector<Points3>& displacements) const;

  const MembraneEnergy& energy() const { return energy_; }

 private:
  void measure(MembraneState& state, double tolerance) const;
  bool factorize(const Points3& x, Points3& gradient);
  // False where it is not finite.
  bool direction(const Points3& gradient, Points3& out) const;

  MembraneEnergy energy_;
  BlockMatrix<3> hessian_;
};

// Positions on a mesh that refine_mesh made from the one `coarse` belongs to: midpoints, except for
// glued vertices, which are taken from `glued`.
Points3 prolong(const MembraneMesh& fine, const Points3& coarse, const Points3& glued);

}  // namespace curveups
