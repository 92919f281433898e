// SPDX-License-Identifier: LGPL-2.1-or-later
// How far front and back membrane may differ in pull, and how far friction may change, each alone,
// until a design no longer holds. Every sample is a design of its own that settles.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "curveups/core/finding.hpp"

namespace curveups {

// End of one search: the last sample that holds, and the failure at the next one, if any.
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

// Failure where each side's membrane pulls this many times as hard, at this friction.
using WindowSample =
    std::function<std::optional<Finding>(const std::array<double, 2>& pull, double friction)>;

// friction: the design's own, where it holds. From one sample to the next until one fails; then the
// range between it and its neighbour is halved twice. Nothing says that it would not hold again
// further on. All ends are searched at once where there are threads.
std::vector<WindowRange> process_window(double friction, const WindowSample& sample);

}  // namespace curveups
