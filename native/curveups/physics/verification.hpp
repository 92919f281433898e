// SPDX-License-Identifier: LGPL-2.1-or-later
// The exact physical model of a design and its verdict: membranes, contact forces as in the paper,
// contacts that push only, and what a user must know before printing. Tiles touch at the corners of
// their interfaces.
#pragma once

#include "curveups/core/progress.hpp"
#include "curveups/physics/solved_design.hpp"
#include "curveups/physics/verification_report.hpp"

namespace curveups {

struct VerificationOptions {
  // Weak contact points are enough to know: then neither cone programs nor clearances are computed,
  // and there is no verdict (VerificationReport::complete).
  bool weak_is_enough = false;
};

// Throws what make_geometry and plan_bumps throw (InfeasibleDesign, TopologyError, InvalidInput),
// SolverFailure, Cancelled. Results do not depend on the number of threads.
VerificationReport verify_design(const Design& design, const Progress& progress,
                                 const VerificationOptions& options = {});
// The same of a design that is solved. Throws what plan_bumps throws, SolverFailure, Cancelled.
VerificationReport verify_solved(const DesignGeometry& geometry, const SolvedHandle& solved,
                                 const Progress& progress, const VerificationOptions& options = {});

// Contact points of printed tiles: tips of bumps (bump_tips) at contacts that have some, else the
// corners of the interface (contact_corners).
std::vector<ContactPoint> points_at_tips(const std::vector<ContactPoint>& corners,
                                         const std::vector<Points3>& tips);

}  // namespace curveups
