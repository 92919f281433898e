// SPDX-License-Identifier: LGPL-2.1-or-later
// Outcome of an iterative solver: one type for all solvers.
#pragma once

namespace curveups {

enum class SolveStatus {
  converged,   // to its tolerance; a feasibility problem is certified feasible
  stopped,     // by the progress sink, with the best so far
  unfinished,  // the iterations ran out, or none improves any more
  infeasible   // proven: no point meets the constraints
};

struct SolveReport {
  SolveStatus status = SolveStatus::unfinished;
  int iterations = 0;
  // Largest violation (mm) of a layout, or largest relative force on a free vertex of a
  // membrane.
  double residual = 0;

  bool converged() const { return status == SolveStatus::converged; }
  bool stopped() const { return status == SolveStatus::stopped; }
};

}  // namespace curveups
