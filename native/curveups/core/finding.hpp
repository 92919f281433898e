// SPDX-License-Identifier: LGPL-2.1-or-later
// Reasons, warnings and information about a surface, a design or its bodies, as values.
// Workbench/curveups/base/sentences.py has a sentence for every kind, in any language.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "curveups/core/sort_unique.hpp"

namespace curveups {

struct Finding {
  using Pairs = std::vector<std::array<int, 2>>;
  // Number; words (name of a body, "front", an error's text); rows of F or V; pairs of rows of F;
  // parts of the same sentence.
  using Figure =
      std::variant<int, double, std::string, std::vector<int>, Pairs, std::vector<Finding>>;

  std::string kind;
  std::vector<int> tiles = {};                 // rows of F concerned, ascending; empty: all
  std::map<std::string, Figure> figures = {};  // figures of its sentence
  bool is_error = false;                       // true: the surface can't become tiles

  bool operator==(const Finding& other) const {
    return kind == other.kind && tiles == other.tiles && figures == other.figures &&
           is_error == other.is_error;
  }
};

// The tiles of pairs, each once, ascending.
inline std::vector<int> tiles_of(const Finding::Pairs& pairs) {
  std::vector<int> tiles;
  for (const auto& pair : pairs) tiles.insert(tiles.end(), pair.begin(), pair.end());
  sort_unique(tiles);
  return tiles;
}

}  // namespace curveups
