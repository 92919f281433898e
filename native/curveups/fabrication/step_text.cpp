// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/step_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

std::string hexadecimal(unsigned code) {
  char digits[12];
  std::snprintf(digits, sizeof digits, code > 0xFFFF ? "%08X" : "%04X", code);
  return (code > 0xFFFF ? "\\X4\\" : "\\X2\\") + std::string(digits) + "\\X0\\";
}

// Returns the code point at text[at] and moves `at` behind it; invalid UTF-8 gives its bytes.
unsigned next_code_point(const std::string& text, std::size_t& at) {
  const unsigned char first = text[at++];
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  unsigned code = more ? first & (0x3F >> more) : first;
  for (int k = 0; k < more && at < text.size() && (text[at] & 0xC0) == 0x80; ++k) {
    code = code << 6 | (text[at++] & 0x3F);
  }
  return code;
}

}  // namespace

std::string step_string(const std::string& utf8) {
  std::string out = "'";
  for (std::size_t at = 0; at < utf8.size();) {
    const unsigned code = next_code_point(utf8, at);
    if (code == '\'' || code == '\\')
      out.append(2, static_cast<char>(code));
    else if (code > 0x7E)
      out += hexadecimal(code);
    else if (code >= 0x20)
      out += static_cast<char>(code);
  }
  return out + "'";
}

StepText::StepText(const std::string& title) {
  text_ = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('CurveUps'),'2;1');\nFILE_NAME(" +
          step_string(title) +
          ",'1970-01-01T00:00:00',(''),(''),'CurveUps','CurveUps','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n";
}

const std::string& StepText::finish() { return text_ += "ENDSEC;\nEND-ISO-10303-21;\n"; }

void StepText::append(double value) {
  if (!std::isfinite(value)) {
    throw SolverFailure("a coordinate of a solid is not finite",
                        "report this with the design file");
  }
  // Shortest digits that read back the same, with the decimal point that STEP requires.
  char digits[40];
  char* const end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  char* const exponent = std::find(digits, end, 'e');
  text_.append(digits, exponent);
  if (std::find(digits, exponent, '.') == exponent) text_ += '.';
  if (exponent == end) return;
  text_ += 'E';
  text_.append(exponent + 1, end);
}

void StepText::append(StepId id) {
  char digits[16];
  text_ += '#';
  text_.append(digits, std::to_chars(digits, digits + sizeof digits, static_cast<int>(id)).ptr);
}

void StepText::append(const Vec3& v) {
  const char* separator = "(";
  for (int k = 0; k < 3; ++k) {
    append(separator);
    append(v[k]);
    separator = ",";
  }
  append(")");
}

void StepText::append(const std::vector<StepId>& ids) {
  append("(");
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (k > 0) append(k % 12 ? "," : ",\n");  // some readers have short lines
    append(ids[k]);
  }
  append(")");
}

}  // namespace curveups
