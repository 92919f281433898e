// SPDX-License-Identifier: LGPL-2.1-or-later
// The exact physical model of a design and its verdict: membranes, contact forces as in the paper,
// contacts that push only (at the interfaces' corners, and at the bumps' tips where tiles carry
// bumps), and what a user must know before printing.
#pragma once

#include "curveups/core/progress.hpp"
#include "curveups/physics/solved_design.hpp"
#include "curveups/physics/verification_report.hpp"

namespace curveups {

struct VerificationOptions {
  // Where contact points push too weakly or glue is overloaded that is enough to know: neither cone
  // programs nor clearances nor loose pins are looked at, and there is no verdict
  // (VerificationReport::complete).
  bool weak_is_enough = false;
};

// store: asked for what is solved of this very design, and left with it; null where nobody needs
// it. Throws what make_geometry and plan_bumps throw (InfeasibleDesign, TopologyError,
// InvalidInput), SolverFailure, Cancelled. Results do not depend on the number of threads, nor on
// the store.
VerificationReport verify_design(const Design& design, SolutionStore* store,
                                 const Progress& progress, const VerificationOptions& options = {});

}  // namespace curveups
