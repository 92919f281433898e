// SPDX-License-Identifier: LGPL-2.1-or-later
// One side's membrane of a design, solved on two nested meshes: the coarser one is the start of the
// finer, and the difference of the two estimates the error of discretisation.
#pragma once

#include <array>

#include "curveups/core/errors.hpp"
#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"
#include "curveups/physics/elastic_forces.hpp"

namespace curveups {

// Pin corners are singularities (an angle of about 300 degrees with held sides): forces converge as
// h whatever the grading. Fine and coarse mesh have elements of sizes h and 2 h, so that the linear
// extrapolation 2 f(h) - f(2 h) removes the leading error; it balances exactly, as both do.
template <class Forces>
Forces extrapolate(const Forces& fine, const Forces& coarse) {
  return 2 * fine - coarse;
}

// A membrane at its equilibrium on one mesh.
struct SolvedMembrane {
  MembraneMesh mesh;
  Points2 flat_corners;      // 3 M pin corners in the layout ...
  Points3 actuated_corners;  // ... and in space
  MembraneState state;
};

// Moves its pins in space; free vertices go along with the pins around them, then find their
// equilibrium. equilibrium: of its mesh and rest shape. Returns whether they found it.
bool move_pins(SolvedMembrane& membrane, MembraneEquilibrium& equilibrium,
               const Points3& actuated_corners, const Progress& progress = {});

struct MembraneSolution {
  MembraneDomain domain;
  SolvedMembrane coarse;
  MembraneMesh mesh;                     // the fine one
  Points2 flat;                          // of its vertices
  Points3 pin_corners;                   // actuated, 3 M x 3
  MembraneState state;                   // on the fine mesh
  Points3 forces;                        // at pin corners, 3 M x 3, N
  Points3 coarse_forces;                 // the same from the coarse mesh
  std::vector<TriangleStretch> stretch;  // per triangle of `mesh`
  int free_vertices = 0;                 // of `mesh`
};

// Error of a side's membrane whose equilibrium was not found.
SolverFailure no_equilibrium(Side side);
MembraneMeshOptions membrane_mesh_options(const Parameters& parameters);
MembraneMaterial membrane_material(const Parameters& parameters, Side side);
// Equilibrium problem of one side's membrane on its mesh. flat: the mesh's vertices in the layout.
MembraneEquilibrium membrane_equilibrium(const MembraneMesh& mesh, const Points2& flat,
                                         const Parameters& parameters, Side side);

// Front and back, at once where there are threads; calls of progress come one at a time.
// halvings: as MembraneMeshOptions have it. Throws what make_membrane_mesh throws, and Cancelled.
std::array<MembraneSolution, 2> solve_membranes(const DesignGeometry& geometry,
                                                const FlatPoses& poses, const Array6& q,
                                                const Parameters& parameters,
                                                const Progress& progress,
                                                const std::vector<int>& halvings = {});

// Both meshes follow pins that are elsewhere in space (where tiles have settled), each from where
// it was; pin_corners, states, forces and stretches are then those of the new places. corners: as
// MembraneSolution::pin_corners. Returns whether both found their equilibrium.
bool move_pins(MembraneSolution& solution, const Points3& corners, const Parameters& parameters);

}  // namespace curveups
