// SPDX-License-Identifier: LGPL-2.1-or-later
// Texts letter by letter.
#pragma once

#include <string>

namespace curveups {

// The code point at text[at], which moves behind it; what is no UTF-8 stands for itself.
inline unsigned next_code_point(const std::string& text, std::size_t& at) {
  const unsigned char first = text[at++];
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  unsigned code = more ? first & (0x3F >> more) : first;
  for (int k = 0; k < more && at < text.size() && (text[at] & 0xC0) == 0x80; ++k) {
    code = code << 6 | (text[at++] & 0x3F);
  }
  return code;
}

}  // namespace curveups
