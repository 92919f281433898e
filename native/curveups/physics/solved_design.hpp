// SPDX-License-Identifier: LGPL-2.1-or-later
// Membranes of a design at their equilibrium with the contact forces that follow. Verification
// reports on them, and repair starts from them.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "curveups/physics/clearance.hpp"
#include "curveups/physics/contact_forces.hpp"
#include "curveups/physics/loads.hpp"
#include "curveups/physics/membrane_solution.hpp"
#include "curveups/physics/unilateral.hpp"

namespace curveups {

struct SolvedDesign {
  Design design;
  std::array<MembraneSolution, 2> membranes;  // front, back
  Wrenches elastic;      // of the membranes on the tiles, extrapolated from both meshes
  Carried carried;       // where the weight goes
  Wrenches loads;        // of membranes, weight and table
  ContactForces forces;  // least squares, under these loads
  // Estimated error of normal forces by the mesh, relative to their mean: mean over the points,
  // largest, and of the least normal force.
  double normal_force_error = 0, largest_normal_force_error = 0, least_force_error = 0;
  // Contacts with a point that exceeds f_min by less than its error, ascending; none where a point
  // is below the parameter f_min_ratio.
  std::vector<std::array<int, 2>> undecided;
  double f_min_ratio =
      0;  // f_min over the mean normal force: the parameter, or the error if larger

  double f_min() const { return f_min_ratio * std::max(0.0, forces.normal_mean); }  // N
};

// Solved once, and read by verification, repair and settling alike.
using SolvedHandle = std::shared_ptr<const SolvedDesign>;

// Overestimate of the least force where each force has its own error: min n - min (n - error).
// A least force of this size leaves every point pushing within its error, which the mean of the
// errors does not. Same sizes; 0 without forces.
double error_of_least(const Eigen::ArrayXd& force, const Eigen::ArrayXd& error);

// geometry: make_geometry's of the design. Throws what solve_membranes and solve_contact_forces
// throw, Cancelled.
SolvedDesign solve_design(const DesignGeometry& geometry, const Design& design,
                          const Progress& progress);

// Corners of the interfaces of a design. Contacts between two held tiles are left out: the hand
// that holds the tiles provides their forces.
std::vector<ContactPoint> contact_corners(const DesignGeometry& geometry,
                                          const Parameters& parameters);
// The balance of a design's tiles at these contact points, not factorized yet.
BalanceSystem make_balance_system(const DesignGeometry& geometry, const Parameters& parameters,
                                  std::vector<ContactPoint> points);
// At the contact corners.
BalanceSystem make_balance_system(const DesignGeometry& geometry, const Parameters& parameters);

// The unit of a design's forces, N: the mean normal force of contacts, where membranes press.
double force_scale(const SolvedDesign& solved);

// The largest floor of pushing forces within friction (unilateral.hpp) at the contact corners.
// system: the balance there, whose factorization changes. Throws what solve_unilateral throws.
UnilateralResult find_floor(const SolvedDesign& solved, BalanceSystem& system,
                            const Progress& progress);

}  // namespace curveups
