// SPDX-License-Identifier: LGPL-2.1-or-later
// Labels: a tab beside one anchor of each piece, lower than the pin tops, so that glue and membrane
// leave its letters free.
#pragma once

#include <optional>
#include <string>

#include "curveups/bodies/anchors.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/design/parameters.hpp"
#include "curveups/fabrication/engraving.hpp"

namespace curveups {

// Where a label goes: the axis of its anchor, the outline of both, counter-clockwise, which begins
// with what the tab leaves of the anchor's circle, and the middle of its text.
struct LabelPlace {
  Vec2 centre, middle;
  Polygon outline;
};

// Finds a place for a text of this size (mm) beside an anchor of the piece and enters it into the
// piece's footprint (labelled, tab, outline): clear of all tiles, anchors and labels so far, beyond
// the slabs of other pieces, and where it makes the box around everything grow least. Nothing where
// there is no room.
std::optional<LabelPlace> place_label(std::vector<PieceFootprint>& pieces, int piece,
                                      const Vec2& text_size, const Parameters& parameters);

// The place in a print that is turned over about the x axis.
LabelPlace turned_over(const LabelPlace& place);

// The anchor with its tab: the outline from z = 0 to `tab_height`, a cylinder (of chords) from
// there to `height`; the text sunk into the tab by `depth`.
PrintBody make_labelled_anchor(const LabelPlace& place, double height, double tab_height,
                               const EngravedText& text, double depth);

}  // namespace curveups
