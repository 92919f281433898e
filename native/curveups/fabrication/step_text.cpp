// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/step_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "curveups/fabrication/file_formats.hpp"

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

StepText::StepText(const std::string& title, const std::string& path) : file_(path) {
  text_ = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('CurveUps'),'2;1');\nFILE_NAME(" +
          step_string(title) +
          ",'1970-01-01T00:00:00',(''),(''),'CurveUps','CurveUps','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n";
}

void StepText::finish() {
  text_ += "ENDSEC;\nEND-ISO-10303-21;\n";
  flush();
  file_.close();
}

void StepText::flush() {
  file_.write(text_);
  text_.clear();
}

void StepText::append(double value) {
  const std::size_t begin = text_.size();
  append_real(text_, value);
  // STEP requires a decimal point, and a capital exponent.
  const std::size_t exponent = text_.find('e', begin);
  if (exponent != text_.npos) text_[exponent] = 'E';
  if (text_.find('.', begin) == text_.npos) text_.insert(std::min(exponent, text_.size()), 1, '.');
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
