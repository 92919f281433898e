// SPDX-License-Identifier: LGPL-2.1-or-later
// Says how an iterative solver ended: one type for all solvers.
#pragma once

namespace curveups {

enum class SolveStatus {
  converged,   // to its tolerance; of a feasibility problem: feasible, certified
  stopped,     // by the progress sink: what is held is the best so far
  unfinished,  // the iterations ran out, or none improves any more
  infeasible   // proven: no point meets the constraints
};

struct SolveReport {
  SolveStatus status = SolveStatus::unfinished;
  int iterations = 0;
  // What is left: the largest violation (mm) of a layout, the largest relative force on a free
  // vertex of a membrane.
  double residual = 0;

  bool converged() const { return status == SolveStatus::converged; }
  bool stopped() const { return status == SolveStatus::stopped; }
  bool infeasible() const { return status == SolveStatus::infeasible; }
};

}  // namespace curveups
