// SPDX-License-Identifier: LGPL-2.1-or-later
// Suggests other parameters for contacts that stay weak.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

// Values that would help, rounded so that they do; none where the parameter is not what is in the
// way, or no value in its range would do.
struct Remedies {
  std::optional<double> H_body;  // mm, thinner
  std::optional<double> L;       // mm, larger tiles on the same target
  std::optional<double> tau;     // stretched further
};

// pins: tiles whose pins want room: with H_body alone, or L alone, all their pins could have a
// quarter more than A_pin_min. Closed forms that leave truncation aside: with the shift of the back
// edges H_body tan(fold / 2), and folds, areas and lengths of a smooth target as L, L^2 and L.
// weak: tile pairs of contacts; with tau no membrane between their pins is longer at rest than 0.9
// of what it spans.
Remedies find_remedies(const Design& design, const std::vector<int>& pins,
                       const std::vector<std::array<int, 2>>& weak);

}  // namespace curveups
