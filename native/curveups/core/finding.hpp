// SPDX-License-Identifier: LGPL-2.1-or-later
// What speaks for or against a surface, a design or its bodies, as a value. Sentences are made of
// it in one place, in any language: Workbench/curveups/base/sentences.py has one for every kind.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace curveups {

struct Finding {
  using Pairs = std::vector<std::array<int, 2>>;
  // Numbers; words (of a body, "front", an error's text); rows of F or of V; pairs of rows of F;
  // and what belongs into the same sentence.
  using Figure =
      std::variant<int, double, std::string, std::vector<int>, Pairs, std::vector<Finding>>;

  std::string kind;
  std::vector<int> tiles = {};                 // that it is about, ascending; none: all of them
  std::map<std::string, Figure> figures = {};  // that its sentence names
  bool is_error = false;                       // nothing can be made of a surface like this

  bool operator==(const Finding& other) const {
    return kind == other.kind && tiles == other.tiles && figures == other.figures &&
           is_error == other.is_error;
  }
};

// The tiles of pairs, each once, ascending.
inline std::vector<int> tiles_of(const Finding::Pairs& pairs) {
  std::vector<int> tiles;
  for (const auto& pair : pairs) tiles.insert(tiles.end(), pair.begin(), pair.end());
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

}  // namespace curveups
