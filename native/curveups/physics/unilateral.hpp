// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts that push only and slide beyond Coulomb's cone: is there any balanced set of forces, and
// with which least normal force at every point? A second-order cone program over the tiles'
// balance:
//   maximise s  subject to  A f + b = 0,  n >= s,  |t| <= mu n,  s <= cap,
// at every point (cone_program.hpp).
//
// Infeasibility is never inferred from divergence: if the program above is not solved, the relaxed
// one with |t| <= mu (n - s) in place of |t| <= mu n is, which always has a solution (s negative: a
// pull of -s that each point would have to bear); its optimum decides, with a duality gap that is
// checked. A feasible answer is certified by the forces themselves: their balance and cones are
// checked again before they are reported.
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
  // Points that hold the floor down, by falling weight in the optimum (dual solution), at most 20.
  std::vector<int> critical_points;
  // How the largest floor follows small changes of loads b, balance A and normals n (envelope
  // theorem; multipliers of the optimum): -motion . (db + dA f) + sum_p by_normal_p . dn_p, N.
  Array6 motion;      // virtual motion of the tiles (BalanceSystem::expand)
  Points3 by_normal;  // per point, N
};

// start: the least-squares forces of the same system. Leaves the system's factorization changed.
// Throws Cancelled.
UnilateralResult solve_unilateral(BalanceSystem& system, const Wrenches& loads,
                                  const Points3& start, const UnilateralOptions& options,
                                  const Progress& progress = {});

}  // namespace curveups
