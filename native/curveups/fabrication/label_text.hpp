// SPDX-License-Identifier: LGPL-2.1-or-later
// What a label says: names of any language in the few letters that can be engraved, in few lines.
#pragma once

#include <string>
#include <vector>

namespace curveups {

// A UTF-8 text in capitals, digits, '-', '_', '.' and blanks: German umlauts become two letters,
// other Latin letters lose their accents, all else becomes '-'.
std::string engravable(const std::string& utf8);

struct LabelText {
  std::vector<std::string> lines;
  bool whole = true;  // false where the name had to be cut short or has letters of no use here
};

// The name, then the note (words), in lines at most `width` cells wide (see text_cells): broken
// behind '-' and '_' and at blanks, within words only where one is too long for a line. A name of
// more than three lines is cut short and ends in "..".
LabelText label_text(const std::string& name, const std::string& note, int width);

}  // namespace curveups
