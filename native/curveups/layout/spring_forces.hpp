// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact forces as the layout's springs see them (Eq. 16): what can be said of a layout in
// milliseconds, while the exact model takes seconds.
#pragma once

#include "curveups/design/design.hpp"

namespace curveups {

// Per contact the least normal force at the ends of its interface, N. Each membrane is a strip
// between two facing pin edges: stretched by tau before, and by tau B / rest now, it pulls with its
// neo-Hookean stress across the strip's width at the height of the pins' ends; the two strips'
// forces go to the interface's front and back edges as on a lever, two points each. Nothing of the
// rest of the design is seen, so that forces are some third of the exact ones; where the springs
// are weakest contacts are likely to be weak, and the ratio to the mean is what counts.
Eigen::VectorXd spring_forces(const DesignGeometry& geometry, const Parameters& parameters,
                              const FlatPoses& poses, const Array6& q);

// Contacts whose force is below f_min_ratio times the mean.
std::vector<int> weak_by_springs(const Eigen::VectorXd& forces, double f_min_ratio);

}  // namespace curveups
