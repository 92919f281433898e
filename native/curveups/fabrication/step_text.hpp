// SPDX-License-Identifier: LGPL-2.1-or-later
// The text of a STEP file (ISO 10303-21), entity after entity, straight to the disk.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// The number of an entity.
enum class StepId : int {};

// Numbers have all the digits that doubles need to read back the same. Throws IoError, and
// SolverFailure for a number that is not finite.
class StepText {
 public:
  // Opens `path` and writes the header; AP214. No date.
  StepText(const std::string& path, const std::string& title);
  ~StepText();
  StepText(const StepText&) = delete;
  StepText& operator=(const StepText&) = delete;

  // One entity put together from its parts: text as it is, numbers, ids, points and lists of ids.
  template <class... Parts>
  StepId add(const Parts&... parts) {
    const StepId id{++count_};
    append(id);
    append("=");
    (append(parts), ...);
    append(";\n");
    if (buffer_.size() > buffer_limit) flush();
    return id;
  }

  // Ends the file. Without it the file stays incomplete.
  void finish();

 private:
  static constexpr std::size_t buffer_limit = 1 << 20;

  void append(const char* text) { buffer_ += text; }
  void append(const std::string& text) { buffer_ += text; }
  void append(double value);
  void append(StepId id);
  void append(const Vec3& v);
  void append(const std::vector<StepId>& ids);
  void flush();

  std::string path_;
  std::FILE* file_;
  std::string buffer_;
  int count_ = 0;
};

// A text as a STEP string, quotes included: UTF-8 outside ASCII is encoded, control characters are
// left out.
std::string step_string(const std::string& utf8);

}  // namespace curveups
