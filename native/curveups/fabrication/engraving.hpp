// SPDX-License-Identifier: LGPL-2.1-or-later
// Text as outlines of square cells, for engraving a few letters into a small round face.
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
  std::vector<std::string> lines;   // what could be written
  double stroke = 0;                // width of all strokes, mm
};

// Rows of cells of a text ('#' and '.'), five high. Lower case counts as upper case; characters
// without a glyph become '-'. No two cells touch in a corner alone.
std::vector<std::string> text_cells(const std::string& text);

// `piece`, `name` and `version` one above the other, in strokes as wide as fit into the disc but at
// least least_stroke; the name is cut short, then the version left out, where they do not fit.
// No regions where nothing fits.
EngravedText engrave_text(const std::string& name, const std::string& version,
                          const std::string& piece, double disc_radius, double least_stroke);

}  // namespace curveups
