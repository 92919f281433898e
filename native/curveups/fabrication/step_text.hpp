// SPDX-License-Identifier: LGPL-2.1-or-later
// Text of a STEP file (ISO 10303-21), entity after entity.
#pragma once

#include <string>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// The number of an entity.
enum class StepId : int {};

// Numbers have all the digits that doubles need to read back the same. Throws SolverFailure for a
// number that is not finite.
class StepText {
 public:
  // Begins with the header; AP214. No date.
  explicit StepText(const std::string& title);

  // One entity put together from its parts: text as it is, numbers, ids, points and lists of ids.
  template <class... Parts>
  StepId add(const Parts&... parts) {
    const StepId id{++count_};
    append(id);
    append("=");
    (append(parts), ...);
    append(";\n");
    return id;
  }

  // The whole file; nothing can be added after it.
  const std::string& finish();

 private:
  void append(const char* text) { text_ += text; }
  void append(const std::string& text) { text_ += text; }
  void append(double value);
  void append(StepId id);
  void append(const Vec3& v);
  void append(const std::vector<StepId>& ids);

  std::string text_;
  int count_ = 0;
};

// A text as a STEP string, quotes included: UTF-8 outside ASCII is encoded, control characters are
// left out.
std::string step_string(const std::string& utf8);

}  // namespace curveups
