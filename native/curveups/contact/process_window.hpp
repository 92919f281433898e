// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a design's materials and its print may be from what it was made for until it no longer
// holds. Tiles settle from where they are at the neighbouring sample, as it happens to a piece.
#pragma once

#include <string>

#include "curveups/contact/settling.hpp"
#include "curveups/physics/membrane_figures.hpp"

namespace curveups {

// Of the range between the last sample that holds and the first that fails.
inline constexpr int window_halvings = 2;

// Where a walk from the design as it stands ends: at the last sample where the verdict stays, and
// with what fails at the next one, if any does.
struct WindowEnd {
  double value = 0;
  std::optional<Finding> failure;
};

// Friction falls by fifths of its coefficient where the design stands and holds, to where it no
// longer does; the range between the last two samples is halved so many times. Nothing says that it
// would not hold again further down.
WindowEnd holding_friction(const Settling& standing, int halvings);

// The worst corners of the box of margin_mismatch and margin_friction.
struct Margin {
  std::string mode = "off";
  double mismatch = 0, friction_coefficient = 0;  // %, as asked
  // Whether the design holds at all of them; none where that was not asked or is not known.
  std::optional<bool> met;
  // What fails, of the corners that do: with the front pulling harder, and the back.
  std::array<std::optional<Finding>, 2> failure;
};
Margin find_margin(const Settling& standing, const Parameters& parameters);

// The range of one parameter, all others as they are, in which the verdict stays.
struct WindowRange {
  std::string parameter, unit;
  std::string verdict;  // that is asked: "holds" or "glue"
  std::array<double, 2> searched{};
  std::array<WindowEnd, 2> end;
};
// standing: where the design holds. lowest_friction: holding_friction's. Its ends are looked for at
// once where there are threads.
std::vector<WindowRange> process_window(const Settling& standing, const WindowEnd& lowest_friction,
                                        const LargestGlueLoads& glue);

}  // namespace curveups
