// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "curveups/fabrication/engraving.hpp"
#include "curveups/fabrication/label_text.hpp"

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

TEST(Engraving, RegionsAreTheStrokesInTheirBox) {
  for (const std::vector<std::string>& lines :
       {std::vector<std::string>{"HALF-SPHERE", "P1 0.1"}, {"X"}}) {
    SCOPED_TRACE(lines[0]);
    const EngravedText text = engrave(lines, 0.5);
    EXPECT_NEAR(text.size.y(), lines.size() * 2.5 + (lines.size() - 1) * 1.0, 1e-12);
    double cells = 0, ink = 0;
    Vec2 low(1e300, 1e300), high = -low;
    for (const std::string& line : lines) cells += cell_count(line);
    for (const TextRegion& region : text.regions) {
      EXPECT_GT(area(region.outer), 0);
      ink += area(region.outer);
      for (const Polygon& hole : region.holes) {
        EXPECT_LT(area(hole), 0);
        ink += area(hole);
      }
      for (const Vec2& p : region.outer) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
    EXPECT_NEAR(ink, cells * 0.25, 1e-9 * ink);
    EXPECT_LT((high - 0.5 * text.size).norm(), 1e-9);
    EXPECT_LT((low + 0.5 * text.size).norm(), 1e-9);
  }
}

TEST(Engraving, LettersHaveTheirHoles) {
  // With one, two and three closed counters: P, P0, P8.
  for (const auto& [piece, holes] :
       std::vector<std::pair<std::string, std::size_t>>{{"P1", 1}, {"P0", 2}, {"P8", 3}}) {
    const EngravedText text = engrave({piece}, 0.3);
    std::size_t found = 0;
    for (const TextRegion& region : text.regions) found += region.holes.size();
    EXPECT_EQ(found, holes) << piece;
    EXPECT_EQ(text.regions.size(), piece.size());
  }
}

TEST(LabelText, KeepsNamesWhole) {
  const auto lines = [](const char* name) { return label_text(name, "P1 0.1 FRONT", 52); };
  EXPECT_EQ(lines("half-sphere").lines, (std::vector<std::string>{"HALF-SPHERE", "P1 0.1 FRONT"}));
  EXPECT_EQ(lines(u8"Sch\u00fcssel gro\u00df").lines,
            (std::vector<std::string>{"SCHUESSEL", "GROSS", "P1 0.1 FRONT"}));
  // Behind hyphens rather than within words, but within where a word is too long.
  const LabelText wrapped = lines("lamp_shade-of-the-second-kind");
  EXPECT_EQ(wrapped.lines,
            (std::vector<std::string>{"LAMP_SHADE-", "OF-THE-", "SECOND-KIND", "P1 0.1 FRONT"}));
  EXPECT_EQ(lines("abcdefghijklmnopqrs").lines.size(), 3u);
  for (const char* name : {"half-sphere", "lamp_shade-of-the-second-kind", "abcdefghijklmnopqrs"}) {
    std::string all;
    for (const std::string& line : lines(name).lines) {
      EXPECT_LE(text_cells(line)[0].size(), 52u);
      all += line;
    }
    EXPECT_EQ(all, engravable(name) + "P1 0.1 FRONT");
    EXPECT_TRUE(lines(name).whole);
  }
}

TEST(LabelText, SaysWhereANameIsCutShort) {
  const LabelText text = label_text(std::string(100, 'w'), "P1", 52);
  EXPECT_FALSE(text.whole);
  ASSERT_EQ(text.lines.size(), 4u);
  EXPECT_EQ(text.lines[2].substr(text.lines[2].size() - 2), "..");
  EXPECT_EQ(text.lines[3], "P1");
  EXPECT_FALSE(label_text(u8"\u5c4b\u6839", "P1", 52).whole);
}

TEST(LabelText, WritesLatinLettersWithoutAccents) {
  EXPECT_EQ(engravable(u8"\u00c0\u00e9\u00ff\u0161\u017b\u0153"), "AEYSZOE");
  EXPECT_EQ(engravable(u8"u\u0308"), "U");  // as file systems that take letters apart
  EXPECT_EQ(engravable("a  b/c"), "A B-C");
  EXPECT_EQ(engravable("\xff"), "-");  // no UTF-8, but no reason to fail
}

}  // namespace
}  // namespace curveups
