// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/step_text.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

[[noreturn]] void fail(const std::string& path) {
  throw IoError("can't write " + path + ": " + std::strerror(errno),
                "check that the disk has room");
}

std::string hexadecimal(unsigned code) {
  char digits[12];
  std::snprintf(digits, sizeof digits, code > 0xFFFF ? "%08X" : "%04X", code);
  return (code > 0xFFFF ? "\\X4\\" : "\\X2\\") + std::string(digits) + "\\X0\\";
}

// The code point at text[at], which moves behind it; what is no UTF-8 stands for itself.
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

StepText::StepText(const std::string& path, const std::string& title)
    : path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) fail(path_);
  buffer_.reserve(buffer_limit + (1 << 16));
  buffer_ = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('CurveUps'),'2;1');\nFILE_NAME(" +
            step_string(title) +
            ",'1970-01-01T00:00:00',(''),(''),'CurveUps','CurveUps','');\n"
            "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n";
}

StepText::~StepText() {
  if (file_) std::fclose(file_);
}

void StepText::finish() {
  buffer_ += "ENDSEC;\nEND-ISO-10303-21;\n";
  flush();
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail(path_);
}

void StepText::flush() {
  if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) fail(path_);
  buffer_.clear();
}

void StepText::append(double value) {
  if (!std::isfinite(value)) {
    throw SolverFailure("a coordinate of a solid is not finite",
                        "report this with the design file");
  }
  // The shortest digits that read back the same, with the point that STEP wants.
  char digits[40];
  char* const end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  char* const exponent = std::find(digits, end, 'e');
  buffer_.append(digits, exponent);
  if (std::find(digits, exponent, '.') == exponent) buffer_ += '.';
  if (exponent == end) return;
  buffer_ += 'E';
  buffer_.append(exponent + 1, end);
}

void StepText::append(StepId id) {
  char digits[16];
  buffer_ += '#';
  buffer_.append(digits, std::to_chars(digits, digits + sizeof digits, static_cast<int>(id)).ptr);
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
