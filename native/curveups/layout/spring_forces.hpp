// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact forces as the layout's springs see them (Eq. 16): what can be said of a layout in
// milliseconds, while the exact model takes seconds.
#pragma once

#include "curveups/design/design.hpp"

namespace curveups {

// Per contact the normal force at one of the four ends of its interface, N, as if both membranes'
// pull were shared equally. Each membrane is a strip between two facing pin edges: stretched by tau
// before, and by tau B / rest now, it pulls with its neo-Hookean stress. Nothing of the rest of the
// design is seen, so that forces are some third of the exact ones; it is the ratio to the others
// that counts. (Sharing by the pins' levers does worse: the rest of the design evens moments out.)
Eigen::VectorXd spring_forces(const DesignGeometry& geometry, const Parameters& parameters,
                              const FlatPoses& poses, const Array6& q);

// Contacts whose force is below five times f_min_ratio of the mean: a hint, not a verdict. The
// threshold was chosen on targets of low tau, where most of those marked are weak by the exact
// model but not all that are weak are marked; on others none may be (figures in
// resources/docs/cuts.md).
std::vector<int> weak_by_springs(const Eigen::VectorXd& forces, double f_min_ratio);

}  // namespace curveups
