// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts that only push, within Coulomb's cones: largest least normal force of all forces in
// balance. A second-order cone program:
//   maximise s  subject to  A f + b = 0,  n >= s,  |t| <= mu n,  s <= cap,
// at every point (cone_program.hpp).
//
// Infeasibility is never inferred from divergence. If the program is not solved, the relaxed one
// with |t| <= mu (n - s) in place of |t| <= mu n decides, which always has a solution (s negative:
// a pull of -s that each point would have to bear). The forces certify a feasible answer: their
// balance and cones are checked before they are reported.
#pragma once

#include "curveups/core/progress.hpp"
#include "curveups/numerics/solve_report.hpp"
#include "curveups/physics/contact_forces.hpp"

namespace curveups {

struct UnilateralOptions {
  double friction_coefficient = 0.5;
  // The unit of forces (N), and the cap on the floor: the mean normal force of least squares.
  double scale = 1;
  double tolerance = 1e-4;  // on the floor, in units of scale
};

struct UnilateralResult {
  // Converged: the forces balance and push, within friction. Infeasible, proven: without a pull of
  // at least -largest_floor somewhere nothing balances. Unfinished: neither could be shown.
  SolveReport solve;
  // Largest least normal force, N, certified (a lower bound within tolerance of the
  // best); the cap where more is possible. Negative where infeasible.
  double largest_floor = 0;
  Points3 force;  // per point in its basis, N, with that floor
  // Points whose constraints are active, by falling weight in the dual solution, at most 20.
  std::vector<int> critical_points;
  // Change of the largest floor with small changes of loads b, balance A and normals n (envelope
  // theorem; multipliers of the optimum): -motion . (db + dA f) + sum_p by_normal_p . dn_p, N.
  Array6 motion;      // virtual motion of the tiles (BalanceSystem::expand)
  Points3 by_normal;  // per point, N
};

// Tiles of the critical points, each pair once, by falling weight; at most four.
std::vector<std::array<int, 2>> critical_contacts(const UnilateralResult& result,
                                                  const BalanceSystem& system);

// start: the least-squares forces of the same system. Leaves the system's factorization changed.
// Throws Cancelled.
UnilateralResult solve_unilateral(BalanceSystem& system, const Wrenches& loads,
                                  const Points3& start, const UnilateralOptions& options,
                                  const Progress& progress = {});

}  // namespace curveups
