// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <locale>
#include <sstream>

#include "curveups/core/errors.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/design/print_constants.hpp"

namespace curveups {
namespace {

using P = Parameters;

constexpr double least_wall = 0.1;  // mm, around joint holes: solids stay far from degenerate

// Kinds of texts without choices (ParameterInfo::text).
struct Kind {
  std::string_view name;
  bool (*fits)(std::string_view text);
  InvalidInput (*error)(const std::string& text);
};

bool read(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool read(std::string_view text, double& value) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  return stream >> std::noskipws >> value && stream.peek() == EOF;
}

// Words between blanks and commas.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

// Number in "T00012"; 0 where it is none.
int tile_number(std::string_view word) {
  int number = 0;
  return word.substr(0, 1) == "T" && read(word.substr(1), number) ? std::max(0, number) : 0;
}

// Number in "Face12" or "12"; 0 where it is none.
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

void check_text(std::string_view name, std::string_view text) {
  const Kind& kind = kind_of(name);
  const bool list = name == "tiles" || name == "faces";
  for (std::string_view part : list ? words_of(text) : std::vector<std::string_view>{text}) {
    if (!kind.fits(part)) throw kind.error(std::string(part));
  }
}

std::string text_remedy(std::string_view kind) { return kind_of(kind).error("").remedy(); }

const ParameterInfo& find(std::string_view name) {
  if (const ParameterInfo* info = find_parameter(name)) return *info;
  throw InvalidInput("unknown parameter '" + std::string(name) + "'",
                     "list them with 'curveups parameters'");
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string shown(const ParameterValue& value) {
  if (const double* x = std::get_if<double>(&value)) return number(*x);
  if (const bool* b = std::get_if<bool>(&value)) return *b ? "on" : "off";
  return "'" + std::get<std::string>(value) + "'";
}

[[noreturn]] void refuse(const ParameterInfo& info, const ParameterValue& value,
                         const std::string& remedy) {
  throw InvalidInput("parameter " + std::string(info.name) + " can't be " + shown(value), remedy);
}

double to_number(const ParameterInfo& info, const ParameterValue& value) {
  const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
  const std::string range =
      "give a number from " + number(info.minimum) + " to " + number(info.maximum) + unit;
  double x = 0;
  if (const double* given = std::get_if<double>(&value)) {
    x = *given;
  } else if (const std::string* text = std::get_if<std::string>(&value)) {
    if (!read(*text, x)) refuse(info, value, range);
  } else {
    refuse(info, value, range);
  }
  if (!std::isfinite(x) || x < info.minimum || x > info.maximum) refuse(info, value, range);
  return x;
}

bool to_switch(const ParameterInfo& info, const ParameterValue& value) {
  if (const bool* b = std::get_if<bool>(&value)) return *b;
  if (const double* x = std::get_if<double>(&value)) {
    if (*x == 0 || *x == 1) return *x == 1;
  } else {
    const std::string& text = std::get<std::string>(value);
    for (const char* yes : {"on", "true", "yes", "1"}) {
      if (text == yes) return true;
    }
    for (const char* no : {"off", "false", "no", "0"}) {
      if (text == no) return false;
    }
  }
  refuse(info, value, "give on or off");
}

}  // namespace

void set_parameter(Parameters& parameters, std::string_view name, const ParameterValue& value) {
  const ParameterInfo& info = find(name);
  if (const auto* member = std::get_if<double P::*>(&info.member)) {
    parameters.*(*member) = to_number(info, value);
  } else if (const auto* flag = std::get_if<bool P::*>(&info.member)) {
    parameters.*(*flag) = to_switch(info, value);
  } else if (info.choices.empty()) {
    const double* x = std::get_if<double>(&value);
    const std::string* given = std::get_if<std::string>(&value);
    if (!given && !(x && info.text == "pieces")) refuse(info, value, text_remedy(info.text));
    const std::string text = given ? *given : number(*x);
    check_text(info.text, text);
    parameters.*std::get<std::string P::*>(info.member) = text;
  } else {
    std::string choices;
    for (std::string_view choice : info.choices) {
      choices += (choices.empty() ? "" : ", ") + std::string(choice);
    }
    const std::string* text = std::get_if<std::string>(&value);
    if (!text || std::find(info.choices.begin(), info.choices.end(), *text) == info.choices.end()) {
      refuse(info, value, "give one of " + choices);
    }
    parameters.*std::get<std::string P::*>(info.member) = *text;
  }
}

std::vector<int> listed_tiles(std::string_view text) {
  check_text("tiles", text);
  std::vector<int> tiles;
  for (std::string_view word : words_of(text)) tiles.push_back(tile_number(word) - 1);
  sort_unique(tiles);
  return tiles;
}

ParameterValue get_parameter(const Parameters& parameters, std::string_view name) {
  return std::visit([&](auto member) { return ParameterValue(parameters.*member); },
                    find(name).member);
}

bool operator==(const Parameters& a, const Parameters& b) {
  const auto& table = parameter_table();
  return std::all_of(table.begin(), table.end(), [&](const ParameterInfo& info) {
    return std::visit([&](auto member) { return a.*member == b.*member; }, info.member);
  });
}

void check_parameters(const Parameters& p) {
  if (p.p_min > p.p_max) {
    throw InvalidInput(
        "p_min (" + number(p.p_min) + " mm) is larger than p_max (" + number(p.p_max) + " mm)",
        "lower p_min or raise p_max");
  }
  if (p.A_pin_floor > p.A_pin_min) {
    throw InvalidInput("A_pin_floor (" + number(p.A_pin_floor) +
                           " mm2) is larger than A_pin_min (" + number(p.A_pin_min) + " mm2)",
                       "lower A_pin_floor or raise A_pin_min");
  }
  if (p.bumps == "bumps" && p.bump_height >= 2 * p.d_gap_min) {
    throw InvalidInput("bump_height (" + number(p.bump_height) +
                           " mm) does not fit into the flat gap of d_gap_min (" +
                           number(p.d_gap_min) + " mm)",
                       "lower bump_height or raise d_gap_min");
  }
  if (p.support == "soluble" && p.orientation == "front-down") {
    throw InvalidInput(
        "a soluble slab can't be printed front side down: it lies on the bed beside "
        "the back pins",
        "set orientation to front-up, or support to breakaway");
  }
  if (p.joint == "holes" && p.p_floor < least_wall) {
    throw InvalidInput(
        "p_floor (" + number(p.p_floor) + " mm) leaves no wall around joint holes",
        "raise p_floor to " + number(least_wall) + " mm or more, or set joint to none");
  }
  if (p.joint == "holes" && p.support == "breakaway" && p.p_floor <= bridge_depth) {
    throw InvalidInput("bridges enter tiles by " + number(bridge_depth) +
                           " mm: into joint holes, behind " + number(p.p_floor) +
                           " mm of wall (p_floor)",
                       "raise p_floor, or set support to soluble");
  }
}

}  // namespace curveups
