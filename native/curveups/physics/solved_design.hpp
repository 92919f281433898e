// SPDX-License-Identifier: LGPL-2.1-or-later
// Membranes of a design at their equilibrium with the contact forces that follow: what verification
// reports on and repair starts from.
#pragma once

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
  Design design;                              // that all of this belongs to
  std::array<MembraneSolution, 2> membranes;  // front, back
  Wrenches elastic;      // of the membranes on the tiles, extrapolated from both meshes
  Carried carried;       // where the weight goes
  Wrenches loads;        // of membranes, weight and table
  ContactForces forces;  // least squares, under these loads
  // Estimated error of normal forces by the mesh, relative to their mean: mean over the points,
  // largest, and of the least normal force.
  double normal_force_error = 0, largest_normal_force_error = 0, least_force_error = 0;
  // Contacts with a point of which the mesh does not tell whether it reaches f_min, ascending, and
  // how often the mesh was halved around each tile for such points (empty: nowhere).
  std::vector<std::array<int, 2>> undecided;
  std::vector<int> halvings;
  double f_min_ratio = 0;  // f_min over the mean normal force: as asked, or the error where larger
};

// Solved once, and read by verification, repair and settling alike.
using SolvedHandle = std::shared_ptr<const SolvedDesign>;

// How much the least of the forces may be overestimated where each is uncertain by its own error:
// min n - min (n - error). A least force of this size at least leaves every point pushing within
// its error, which the mean of the errors does not. Same sizes; 0 without forces.
double error_of_least(const Eigen::ArrayXd& force, const Eigen::ArrayXd& error);

// Where all points push as hard as f_min_ratio asks for, but some exceed f_min by less than their
// error, the membranes are solved again on a mesh of half the size around the tiles of these
// contacts and their neighbours, at most twice. geometry: make_geometry's of the design. Throws
// what solve_membranes and solve_contact_forces throw, Cancelled.
SolvedDesign solve_design(const DesignGeometry& geometry, const Design& design,
                          const Progress& progress);

// The corners of the interfaces at which the tiles of a design hold one another. Contacts between
// two held tiles are left out: the hand that holds the tiles provides their forces.
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
