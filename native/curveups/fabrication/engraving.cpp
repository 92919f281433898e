// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/engraving.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

namespace curveups {
namespace {

using Glyph = std::array<const char*, 5>;
constexpr int glyph_height = 5;
constexpr int line_gap = 2;

// Drawn so that cells never touch in a corner alone: such outlines would not be manifold.
const std::map<char, Glyph>& font() {
  static const std::map<char, Glyph> glyphs = {
      {'A', {"###", "#.#", "###", "#.#", "#.#"}},
      {'B', {"###.", "#.#.", "####", "#..#", "####"}},
      {'C', {"###", "#..", "#..", "#..", "###"}},
      {'D', {"###.", "#.##", "#..#", "#.##", "###."}},
      {'E', {"###", "#..", "##.", "#..", "###"}},
      {'F', {"###", "#..", "##.", "#..", "#.."}},
      {'G', {"####", "#...", "#.##", "#..#", "####"}},
      {'H', {"#.#", "#.#", "###", "#.#", "#.#"}},
      {'I', {"###", ".#.", ".#.", ".#.", "###"}},
      {'J', {"..#", "..#", "..#", "#.#", "###"}},
      {'K', {"#..#", "#.##", "###.", "#.##", "#..#"}},
      {'L', {"#..", "#..", "#..", "#..", "###"}},
      {'M', {"#####", "#.#.#", "#.#.#", "#...#", "#...#"}},
      {'N', {"##..#", "###.#", "#.###", "#..##", "#...#"}},
      {'O', {"####", "#..#", "#..#", "#..#", "####"}},
      {'P', {"###", "#.#", "###", "#..", "#.."}},
      {'Q', {"####", "#..#", "#..#", "####", "...#"}},
      {'R', {"####", "#..#", "####", "#.#.", "#.##"}},
      {'S', {"###", "#..", "###", "..#", "###"}},
      {'T', {"###", ".#.", ".#.", ".#.", ".#."}},
      {'U', {"#.#", "#.#", "#.#", "#.#", "###"}},
      {'V', {"#...#", "#...#", "##.##", ".###.", "..#.."}},
      {'W', {"#...#", "#...#", "#.#.#", "#.#.#", "#####"}},
      {'X', {"#...#", "##.##", ".###.", "##.##", "#...#"}},
      {'Y', {"#.#", "#.#", "###", ".#.", ".#."}},
      {'Z', {"####", "..##", ".##.", "##..", "####"}},
      {'0', {"###", "#.#", "#.#", "#.#", "###"}},
      {'1', {"##.", ".#.", ".#.", ".#.", "###"}},
      {'2', {"###", "..#", "###", "#..", "###"}},
      {'3', {"###", "..#", "###", "..#", "###"}},
      {'4', {"#.#", "#.#", "###", "..#", "..#"}},
      {'5', {"###", "#..", "###", "..#", "###"}},
      {'6', {"#..", "#..", "###", "#.#", "###"}},
      {'7', {"###", "..#", "..#", "..#", "..#"}},
      {'8', {"###", "#.#", "###", "#.#", "###"}},
      {'9', {"###", "#.#", "###", "..#", "..#"}},
      {'-', {"...", "...", "###", "...", "..."}},
      {'_', {"...", "...", "...", "...", "###"}},
      {'.', {".", ".", ".", ".", "#"}},
      {' ', {"..", "..", "..", "..", ".."}},
  };
  return glyphs;
}

struct Cells {
  int width, height;
  std::vector<char> set;
  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height && set[y * width + x];
  }
};

// Boundaries of the union of cells: outer ones counter-clockwise, holes clockwise.
std::vector<std::vector<std::array<int, 2>>> trace(const Cells& cells) {
  std::map<std::array<int, 2>, std::array<int, 2>> next;
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      if (!cells.at(x, y)) continue;
      if (!cells.at(x, y - 1)) next[{x, y}] = {x + 1, y};
      if (!cells.at(x + 1, y)) next[{x + 1, y}] = {x + 1, y + 1};
      if (!cells.at(x, y + 1)) next[{x + 1, y + 1}] = {x, y + 1};
      if (!cells.at(x - 1, y)) next[{x, y + 1}] = {x, y};
    }
  }
  std::vector<std::vector<std::array<int, 2>>> loops;
  while (!next.empty()) {
    std::vector<std::array<int, 2>> corners;
    std::array<int, 2> at = next.begin()->first;
    for (auto it = next.find(at); it != next.end(); it = next.find(at)) {
      corners.push_back(at);
      at = it->second;
      next.erase(it);
    }
    std::vector<std::array<int, 2>> loop;  // without the points within straight sides
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const auto &a = corners[(k + n - 1) % n], &b = corners[k], &c = corners[(k + 1) % n];
      if ((b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0])) loop.push_back(b);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<TextRegion> regions_of(const std::vector<std::vector<std::string>>& lines,
                                   double cell) {
  const double height = static_cast<double>(lines.size() * (glyph_height + line_gap)) - line_gap;
  std::vector<TextRegion> regions;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    Cells cells{static_cast<int>(lines[l][0].size()), glyph_height, {}};
    for (int y = glyph_height - 1; y >= 0; --y) {
      for (char c : lines[l][y]) cells.set.push_back(c == '#');
    }
    const Vec2 low(
        -0.5 * cells.width,
        0.5 * height - static_cast<double>(l * (glyph_height + line_gap)) - glyph_height);
    std::vector<Polygon> holes;
    const std::size_t first = regions.size();
    for (const auto& loop : trace(cells)) {
      Polygon polygon;
      for (const auto& p : loop) polygon.push_back(cell * (low + Vec2(p[0], p[1])));
      if (area(polygon) > 0) {
        regions.push_back({std::move(polygon), {}});
      } else {
        holes.push_back(std::move(polygon));
      }
    }
    for (Polygon& hole : holes) {
      // A point just inside the letter, beside the hole's first side.
      const Vec2 beside =
          0.5 * (hole[0] + hole[1]) + 0.5 * cell * left_of(hole[1] - hole[0]).normalized();
      for (std::size_t r = first; r < regions.size(); ++r) {
        if (!contains(regions[r].outer, beside)) continue;
        regions[r].holes.push_back(std::move(hole));
        break;
      }
    }
  }
  return regions;
}

}  // namespace

std::vector<std::string> text_cells(const std::string& text) {
  std::vector<std::string> rows(glyph_height);
  for (char c : text) {
    auto it = font().find(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    const Glyph& glyph = it != font().end() ? it->second : font().at('-');
    for (int y = 0; y < glyph_height; ++y) {
      if (!rows[y].empty()) rows[y] += '.';
      rows[y] += glyph[y];
    }
  }
  return rows;
}

EngravedText engrave(const std::vector<std::string>& lines, double stroke) {
  std::vector<std::vector<std::string>> cells;
  std::size_t width = 0;
  for (const std::string& line : lines) {
    cells.push_back(text_cells(line));
    width = std::max(width, cells.back()[0].size());
  }
  EngravedText out;
  out.regions = regions_of(cells, stroke);
  const std::size_t height = lines.size() * (glyph_height + line_gap) - line_gap;
  out.size = stroke * Vec2(static_cast<double>(width), static_cast<double>(height));
  return out;
}

}  // namespace curveups
