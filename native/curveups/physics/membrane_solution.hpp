// SPDX-License-Identifier: LGPL-2.1-or-later
// One side's membrane of a design, solved on two nested meshes: the coarser one is the start of the
// finer, and the difference of the two estimates the error of discretisation.
#pragma once

#include <array>

#include "curveups/core/errors.hpp"
#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"
#include "curveups/physics/balance_system.hpp"
#include "curveups/physics/equilibrium.hpp"

namespace curveups {

// Pin corners are singularities (an angle of about 300 degrees with held sides): forces converge as
// h whatever the grading. Fine and coarse mesh have elements of sizes h and 2 h, so that the linear
// extrapolation 2 f(h) - f(2 h) removes the leading error; it balances exactly, as both do.
inline Wrenches extrapolate(const Wrenches& fine, const Wrenches& coarse) {
  return 2 * fine - coarse;
}

// A membrane at its equilibrium on one mesh.
struct SolvedMembrane {
  MembraneMesh mesh;
  Points2 flat_corners;      // 3 M pin corners in the layout ...
  Points3 actuated_corners;  // ... and in space
  MembraneState state;

  Points2 flat() const { return vertex_positions(mesh.weights, flat_corners); }
};

struct MembraneSolution {
  MembraneDomain domain;
  SolvedMembrane coarse, fine;
  std::vector<TriangleStretch> stretch;  // per triangle of the fine mesh
};

// Wrenches of a membrane on the tiles (paper, A.1). centres: tile_centres.
Wrenches membrane_wrenches(const MembraneMesh& mesh, const MembraneState& state,
                           const Points3& centres);

// Wrenches extrapolated from both meshes.
Wrenches extrapolated_wrenches(const MembraneSolution& membrane, const Points3& centres);

// Error of a side's membrane whose equilibrium was not found.
SolverFailure no_equilibrium(Side side);
// Largest edges of the coarser mesh, mm.
double membrane_mesh_size(const Parameters& parameters);
MembraneMaterial membrane_material(const Parameters& parameters, Side side);
// Equilibrium problem of one side's membrane on its mesh.
MembraneEquilibrium membrane_equilibrium(const SolvedMembrane& membrane,
                                         const Parameters& parameters, Side side);

// Solve front and back, at once where there are threads; calls of progress come one at a time.
// Throws what make_membrane_mesh throws, and Cancelled.
std::array<MembraneSolution, 2> solve_membranes(const DesignGeometry& geometry,
                                                const FlatPoses& poses, const Array6& q,
                                                const Parameters& parameters,
                                                const Progress& progress);

// Move pins in space: free vertices go along with the pins around them, then find their
// equilibrium. equilibrium: of the membrane's mesh and rest shape. Returns whether it was found.
bool move_pins(SolvedMembrane& membrane, MembraneEquilibrium& equilibrium,
               const Points3& actuated_corners, const Progress& progress = {});

// Move the pins of both meshes, from where they are; states and stretches follow. corners: 3 M x 3.
// Returns whether both equilibria were found.
bool move_pins(MembraneSolution& solution, const Points3& corners, const Parameters& parameters);

}  // namespace curveups
