// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact derivatives of least-squares normal forces by poses and insets, through the contact solve
// and the membranes' equilibrium, by adjoints: one back-solve in the contacts' factorization and
// one in each membrane's Hessian per function, whatever the number of unknowns.
//
// For phi = sum_p g_p n_p with G_p = g_p normal_p and z = (A A^T)^-1 A G, contact points held,
//   d phi = -z^T db,
// and z^T b is the virtual work of the membranes' pull on the pins as the tiles move by z: with u
// that motion of the glued vertices, w = [u; -E_ff^-1 E_fg u] and E(x, X) the elastic energy,
//   d(z^T b) = -w^T (E_xx dx + E_xX dX) - E_x . du.
// The mesh follows the pins by its weights (membrane_mesh.hpp).
#pragma once

#include <vector>

#include "curveups/physics/design_forces.hpp"

namespace curveups {

// Derivatives of one function of the normal forces, N per mm and N per rad.
struct ForceGradient {
  Array3 by_pose;   // M x 3, by FlatPoses
  Array6 by_inset;  // M x 6
};

// functions: one column per function, one row per contact point of forces.system(): the weights g.
// Done in batches, so that memory stays bounded; the two membranes at once.
std::vector<ForceGradient> force_gradients(const DesignForces& forces,
                                           const Eigen::MatrixXd& functions);

}  // namespace curveups
