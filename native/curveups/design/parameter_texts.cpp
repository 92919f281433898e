// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/parameter_texts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

struct Kind {
  std::string_view name;
  bool (*fits)(std::string_view text);
  InvalidInput (*error)(const std::string& text);
};

template <class Number>
bool read(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

// What stands between blanks and commas.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

// Of "T00012"; 0 where it is none.
int tile_number(std::string_view word) {
  int number = 0;
  return word.substr(0, 1) == "T" && read(word.substr(1), number) ? std::max(0, number) : 0;
}

// Of "Face12" or "12"; 0 where it is none.
int face_number(std::string_view word) {
  if (word.substr(0, 4) == "Face") word.remove_prefix(4);
  int number = 0;
  return read(word, number) ? number : 0;
}

bool is_tile(std::string_view word) { return tile_number(word) > 0; }

bool is_face(std::string_view word) {
  const std::size_t dash = word.find('-');
  const int first = face_number(word.substr(0, dash));
  const int last = dash == word.npos ? first : face_number(word.substr(dash + 1));
  return first >= 1 && last >= first;
}

bool is_opening(std::string_view text) {
  double place = 0;
  return text == "auto" || text == "largest" || text == "none" ||
         (text.size() > 2 && std::string_view("xyz").find(text[0]) != text.npos &&
          std::string_view("=<>").find(text[1]) != text.npos && read(text.substr(2), place) &&
          std::isfinite(place));
}

bool is_pieces(std::string_view text) {
  int count = 0;
  return text == "auto" || (read(text, count) && text[0] != '0' && count >= 1 && count <= 24);
}

constexpr Kind kinds[] = {
    {"tiles", is_tile,
     [](const std::string& text) {
       return InvalidInput("'" + text + "' is no tile", "name tiles as reports do: T00012,T00345");
     }},
    {"faces", is_face,
     [](const std::string& text) {
       return InvalidInput("'" + text + "' is no face",
                           "name faces as FreeCAD does, from 1: Face3,Face7-9");
     }},
    {"opening", is_opening,
     [](const std::string& text) {
       return InvalidInput("'" + text + "' is no opening",
                           "give auto, largest, none, or a plane as z=0, z>0 or x<12.5");
     }},
    {"pieces", is_pieces,
     [](const std::string& text) {
       return InvalidInput("'" + text + "' is no number of pieces",
                           "give auto, or a whole number from 1 to 24");
     }},
};

const Kind& kind_of(std::string_view name) {
  return *std::find_if(std::begin(kinds), std::end(kinds) - 1,
                       [&](const Kind& kind) { return kind.name == name; });
}

}  // namespace

void check_text(std::string_view name, std::string_view text) {
  const Kind& kind = kind_of(name);
  const bool list = name == "tiles" || name == "faces";
  for (std::string_view part : list ? words_of(text) : std::vector<std::string_view>{text}) {
    if (!kind.fits(part)) throw kind.error(std::string(part));
  }
}

std::string text_remedy(std::string_view kind) { return kind_of(kind).error("").remedy(); }

std::vector<int> listed_tiles(std::string_view text) {
  check_text("tiles", text);
  std::vector<int> tiles;
  for (std::string_view word : words_of(text)) tiles.push_back(tile_number(word) - 1);
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

}  // namespace curveups
