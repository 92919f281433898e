// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers and lists in messages.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace curveups {

// With so many significant digits.
inline std::string number(double x, int digits = 3) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

// The first `most` by their names, then how many more there are.
template <class T, class Name>
std::string listed(const std::vector<T>& items, std::size_t most, Name name) {
  std::string out;
  for (std::size_t i = 0; i < items.size() && i < most; ++i)
    out += (i ? ", " : "") + name(items[i]);
  if (items.size() > most) out += " and " + std::to_string(items.size() - most) + " more";
  return out;
}

}  // namespace curveups
