// SPDX-License-Identifier: LGPL-2.1-or-later
// Text as outlines of square cells, for engraving a few letters.
#pragma once

#include <string>
#include <vector>

#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// A connected region: outer boundary counter-clockwise, holes (the inside of an O) clockwise.
struct TextRegion {
  Polygon outer;
  std::vector<Polygon> holes;
};

struct EngravedText {
  std::vector<TextRegion> regions;  // centred on the origin, x to the right
  Vec2 size = Vec2::Zero();         // of the box around all lines, mm
};

// Rows of cells of a text ('#' and '.'), five high. Lower case counts as upper case; characters
// without a glyph become '-'. No two cells touch in a corner alone.
std::vector<std::string> text_cells(const std::string& text);

// The lines (at least one, none empty) one above the other, letters five strokes (mm) high.
EngravedText engrave(const std::vector<std::string>& lines, double stroke);

}  // namespace curveups
