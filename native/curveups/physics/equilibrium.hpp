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

struct MembraneState {
  Points3 x;         // all mesh vertices, mm
  Points3 gradient;  // dE / dx there, N; the membrane pulls with minus this on its pins
  double energy = 0;
  SolveReport solve;  // residual: largest force on a free vertex over the mean on a glued one
};

// Newton steps by conjugate gradients: most free vertices have a pin within two or three edges, so
// that a dozen iterations do.
class MembraneEquilibrium {
 public:
  MembraneEquilibrium(const MembraneMesh& mesh, const Points2& flat, double tau,
                      const MembraneMaterial& material)
      : energy_(mesh, flat, tau, material), hessian_(energy_.pattern()) {}

  // Truncated Newton method with a backtracking line search, to a residual of 1e-10. start: all
  // vertices, glued ones in their final places. Stops early when progress asks to. Throws
  // SolverFailure where the start has a triangle without area that the density can't bear.
  MembraneState solve(const Points3& start, const Progress& progress = {},
                      const std::string& what = "membrane");

  // Replace the rest shape of the mesh (MembraneEnergy::set_rest).
  void set_rest(const Points2& flat, double tau) { energy_.set_rest(flat, tau); }
  // Factorizes the Hessian at x, for respond(). False where it is not finite.
  bool factorize(const Points3& x);
  // Response of free vertices to displacements of glued ones, by the last factorization: fills in
  // the free rows of each displacement. x: the equilibrium.
  void respond(const Points3& x, std::vector<Points3>& displacements) const;

  const MembraneEnergy& energy() const { return energy_; }

 private:
  void measure(MembraneState& state) const;
  // Newton direction; false where it is not finite.
  bool direction(const MembraneState& state, Points3& out);

  MembraneEnergy energy_;
  BlockMatrix<3> hessian_;
};

// Positions on the refined mesh (refine_mesh) of the one that `coarse` belongs to: midpoints, and
// `glued` at glued vertices.
Points3 prolong(const MembraneMesh& fine, const Points3& coarse, const Points3& glued);

}  // namespace curveups
