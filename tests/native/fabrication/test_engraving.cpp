// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curveups/fabrication/engraving.hpp"

namespace curveups {
namespace {

double cell_count(const std::string& text) {
  double count = 0;
  for (const std::string& row : text_cells(text)) count += std::count(row.begin(), row.end(), '#');
  return count;
}

TEST(Engraving, GlyphsAreFiveHighAndNeverTouchInACornerAlone) {
  const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-.";
  for (char c : all) {
    const std::vector<std::string> cells = text_cells(std::string(1, c) + "A");
    SCOPED_TRACE(c);
    ASSERT_EQ(cells.size(), 5u);
    for (const std::string& row : cells) EXPECT_EQ(row.size(), cells[0].size());
    for (std::size_t y = 0; y + 1 < cells.size(); ++y) {
      for (std::size_t x = 0; x + 1 < cells[y].size(); ++x) {
        const bool a = cells[y][x] == '#', b = cells[y][x + 1] == '#';
        const bool d = cells[y + 1][x] == '#', e = cells[y + 1][x + 1] == '#';
        EXPECT_FALSE((a && e && !b && !d) || (b && d && !a && !e));
      }
    }
  }
  EXPECT_EQ(text_cells("spot"), text_cells("SPOT"));
  EXPECT_EQ(text_cells("a\xc3\xa9"), text_cells("A--"));
  // Letters differ from one another, and digits (S is a 5 in any font of 3 x 5 cells).
  for (const std::string& kind : {all.substr(0, 26), all.substr(26)}) {
    for (std::size_t i = 0; i < kind.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NE(text_cells(kind.substr(i, 1)), text_cells(kind.substr(j, 1)));
      }
    }
  }
}

TEST(Engraving, RegionsAreTheStrokesInsideTheDisc) {
  for (const char* name : {"half-sphere", "spot", "x", "a-very-long-name-of-a-model"}) {
    for (double radius : {3.7, 8.0}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(radius));
      const EngravedText text = engrave_text(name, "0.1", "P12", radius, 0.3);
      ASSERT_FALSE(text.regions.empty());
      EXPECT_GE(text.stroke, 0.3);
      double cells = 0, ink = 0;
      for (const std::string& line : text.lines) cells += cell_count(line);
      for (const TextRegion& region : text.regions) {
        EXPECT_GT(area(region.outer), 0);
        ink += area(region.outer);
        for (const Polygon& hole : region.holes) {
          EXPECT_LT(area(hole), 0);
          ink += area(hole);
        }
        for (const Vec2& p : region.outer) EXPECT_LE(p.norm(), radius + 1e-9);
      }
      EXPECT_NEAR(ink, cells * text.stroke * text.stroke, 1e-9 * ink);
      EXPECT_EQ(text.lines.front(), "P12");
      // A long name is cut short, never the piece.
      EXPECT_TRUE(text.lines.size() < 2 || text.lines[1].size() <= std::string(name).size());
    }
  }
}

TEST(Engraving, LettersHaveTheirHoles) {
  // Of piece names with one, two and three closed counters: P, P0, P8.
  for (const auto& [piece, holes] :
       std::vector<std::pair<std::string, std::size_t>>{{"P1", 1}, {"P0", 2}, {"P8", 3}}) {
    const EngravedText text = engrave_text("", "", piece, 6, 0.3);
    std::size_t found = 0;
    for (const TextRegion& region : text.regions) found += region.holes.size();
    EXPECT_EQ(found, holes) << piece;
    EXPECT_EQ(text.regions.size(), piece.size());
  }
}

TEST(Engraving, LeavesOutWhatDoesNotFit) {
  EXPECT_TRUE(engrave_text("name", "0.1", "P1", 0.5, 0.3).regions.empty());
  const EngravedText small = engrave_text("half-sphere", "0.1", "P1", 2.2, 0.3);
  ASSERT_FALSE(small.regions.empty());
  EXPECT_EQ(small.lines.front(), "P1");
  EXPECT_LT(small.lines.size(), 3u);
}

}  // namespace
}  // namespace curveups
