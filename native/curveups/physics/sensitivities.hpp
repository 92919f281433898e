// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact derivatives of contact forces by poses, insets and actuated vertices, through the contact
// solve and the membranes' equilibrium, by adjoints: one back-solve in the contacts' factorization
// and one in each membrane's Hessian per function, whatever the number of unknowns.
//
// Least squares, f = -A^T y with y = (A A^T)^-1 b: for phi = sum_p g_p n_p . f_p with G_p = g_p
// n_p, z = (A A^T)^-1 A G and G' = G - A^T z, which A maps to zero,
//   d phi = f . dG - z^T db - z^T dA f - y^T dA G'.
// A f acts on a tile by f_p and the torque of f_p about the tile's centre, so that z^T A f is the
// work of f as the tiles move by z: dA only needs the turns of the tiles on either side of a
// point. Likewise z^T b is the work of the membranes' pull on the pins: with u that motion of the
// glued vertices, w = [u; -E_ff^-1 E_fg u] and E(x, X) the elastic energy,
//   d(z^T b) = -w^T (E_xx dx + E_xX dX) - E_x . du.
// The mesh follows the pins by its weights (membrane_mesh.hpp). How pins, contact points and
// normals follow the vertices: vertex_patch.hpp. Tiles' weights and the points at which they rest
// on the ground are taken not to change with the vertices.
#pragma once

#include <vector>

#include "curveups/design/vertex_patch.hpp"
#include "curveups/physics/design_forces.hpp"
#include "curveups/physics/unilateral.hpp"

namespace curveups {

// Derivatives of one function of the contact forces, N per mm and N per rad.
struct ForceGradient {
  Array3 by_pose;     // M x 3, by FlatPoses
  Array6 by_inset;    // M x 6
  Points3 by_vertex;  // a row per given vertex: by its actuated position, FlatPoses fixed
};

// functions: one column per function, one row per contact point of forces.system(): the weights g
// of the least-squares normal forces. vertices: those to differentiate by. Done in batches, so that
// memory stays bounded; the two membranes at once.
std::vector<ForceGradient> force_gradients(const DesignForces& forces,
                                           const Eigen::MatrixXd& functions,
                                           const std::vector<VertexPatch>& vertices);

// Derivatives of -motion . b, the virtual work of the loads, by poses and insets alone. motions:
// virtual motions as BalanceSystem::expand has them.
std::vector<ForceGradient> load_gradients(const DesignForces& forces,
                                          const std::vector<Array6>& motions);

// Derivatives of the largest floor of the unilateral problem under forces' loads, by its
// multipliers.
ForceGradient floor_gradient(const DesignForces& forces, const UnilateralResult& unilateral,
                             const std::vector<VertexPatch>& vertices);

}  // namespace curveups
