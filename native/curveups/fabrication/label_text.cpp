// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/label_text.hpp"

#include <algorithm>
#include <cctype>

#include "curveups/fabrication/engraving.hpp"
#include "curveups/fabrication/utf8.hpp"

namespace curveups {
namespace {

constexpr std::size_t most_name_lines = 3;

// Letters of U+00C0 to U+017F (Latin-1 and Latin Extended-A), one entry each.
std::vector<std::string> latin_letters() {
  std::vector<std::string> letters;
  for (int small = 0; small < 2; ++small) {
    for (const char* letter :
         {"A", "A", "A", "A", "AE", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",
          "D", "N", "O", "O", "O",  "O", "OE", "-", "O", "U", "U", "U", "UE", "Y", "TH", "SS"}) {
      letters.emplace_back(letter);
    }
  }
  letters.back() = "Y";  // small y with two dots; the sharp s has no twin there
  for (const auto& [letter, count] : std::vector<std::pair<const char*, int>>{
           {"A", 6}, {"C", 8},  {"D", 4},  {"E", 10}, {"G", 8}, {"H", 4},  {"I", 10}, {"IJ", 2},
           {"J", 2}, {"K", 3},  {"L", 10}, {"N", 9},  {"O", 6}, {"OE", 2}, {"R", 6},  {"S", 8},
           {"T", 6}, {"U", 12}, {"W", 2},  {"Y", 3},  {"Z", 6}, {"S", 1}}) {
    letters.insert(letters.end(), count, letter);
  }
  return letters;
}

int width_of(const std::string& text) {
  return text.empty() ? 0 : static_cast<int>(text_cells(text)[0].size());
}

std::string without_end_blanks(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// Parts after which a line may end.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (char c : text) {
    words.back() += c;
    if (c == ' ' || c == '-' || c == '_') words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::vector<std::string> wrapped(const std::string& text, int width) {
  std::vector<std::string> lines(1);
  for (std::string word : words_of(text)) {
    if (!lines.back().empty() && width_of(without_end_blanks(lines.back() + word)) > width) {
      lines.emplace_back();
    }
    while (width_of(without_end_blanks(word)) > width) {
      std::size_t fits = word.size();
      while (fits > 1 && width_of(word.substr(0, fits)) > width) --fits;
      lines.back() = word.substr(0, fits);
      lines.emplace_back();
      word.erase(0, fits);
    }
    lines.back() += word;
  }
  std::vector<std::string> out;
  for (const std::string& line : lines) {
    if (std::string shown = without_end_blanks(line); !shown.empty()) out.push_back(shown);
  }
  return out;
}

}  // namespace

std::string engravable(const std::string& utf8) {
  static const std::vector<std::string> latin = latin_letters();
  std::string out;
  for (std::size_t at = 0; at < utf8.size();) {
    const unsigned code = next_code_point(utf8, at);
    const char c = static_cast<char>(code);
    if (code < 0x80 && (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.')) {
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    } else if (code == ' ') {
      if (!out.empty() && out.back() != ' ') out += ' ';
    } else if (code >= 0xC0 && code - 0xC0 < latin.size()) {
      out += latin[code - 0xC0];
    } else if (code < 0x300 || code >= 0x370) {  // no accent that follows its letter
      out += '-';
    }
  }
  return without_end_blanks(out);
}

LabelText label_text(const std::string& name, const std::string& note, int width) {
  LabelText out;
  const std::string letters = engravable(name);
  out.whole = std::any_of(letters.begin(), letters.end(),
                          [](unsigned char c) { return std::isalnum(c) != 0; });
  out.lines = wrapped(letters, width);
  if (out.lines.size() > most_name_lines) {
    out.whole = false;
    out.lines.resize(most_name_lines);
    std::string& last = out.lines.back();
    while (!last.empty() && width_of(last + "..") > width) last.pop_back();
    last += "..";
  }
  for (const std::string& line : wrapped(note, width)) out.lines.push_back(line);
  return out;
}

}  // namespace curveups
