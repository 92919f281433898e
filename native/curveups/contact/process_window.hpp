// SPDX-License-Identifier: LGPL-2.1-or-later
// Process window: ranges of the pull of front against back membrane, and of friction, each alone,
// in which a design holds. Every sample settles by itself.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "curveups/core/finding.hpp"

namespace curveups {

// End of a range: the last sample that holds, and the failure at the next one, if any.
struct WindowEnd {
  double value = 0;
  std::optional<Finding> failure;
};

// The range of one parameter, all others as they are, in which the design holds.
struct WindowRange {
  std::string parameter, unit;
  std::array<double, 2> searched{};
  std::array<WindowEnd, 2> end;
};

// Returns the failure where each side's membrane pulls this many times as hard, at this friction.
using WindowSample =
    std::function<std::optional<Finding>(const std::array<double, 2>& pull, double friction)>;

// Goes from the design's own friction and pull, where it holds, from one sample to the next until
// one fails; then halves the range between it and its neighbour twice. The design might hold again
// further on. All ends are searched in parallel.
std::vector<WindowRange> process_window(double friction, const WindowSample& sample);

}  // namespace curveups
