// SPDX-License-Identifier: LGPL-2.1-or-later
// Text of STEP files (ISO 10303-21) and boundary representations of bodies.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/fabrication/file_formats.hpp"

namespace curveups {

// The number of an entity.
enum class StepId : int {};

// Appends entities to a file. Numbers read back the same. Throws SolverFailure for a number that is
// not finite.
class StepText {
 public:
  // Writes the header of AP214, without a date.
  StepText(const std::string& title, const std::string& path);

  // Adds an entity from its parts: text, numbers, ids, points and lists of ids.
  template <class... Parts>
  StepId add(const Parts&... parts) {
    const StepId id{++count_};
    append(id);
    append("=");
    (append(parts), ...);
    append(";\n");
    if (text_.size() > flush_size) flush();
    return id;
  }

  // Ends the file. Throws what OutputFile::close throws.
  void finish();

 private:
  void append(const char* text) { text_ += text; }
  void append(const std::string& text) { text_ += text; }
  void append(double value);
  void append(StepId id);
  void append(const Vec3& v);
  void append(const std::vector<StepId>& ids);

  static constexpr std::size_t flush_size = 1 << 18;  // bytes
  void flush();

  OutputFile file_;
  std::string text_;
  int count_ = 0;
};

// Quotes a text as a STEP string. UTF-8 outside ASCII is encoded; control characters are left out.
std::string step_string(const std::string& utf8);

// Adds the body's faces with shared edges and vertices; returns its manifold_solid_brep. Caps and
// cylinders are spherical and cylindrical surfaces with seams.
StepId add_step_solid(StepText& step, const PrintBody& body);

}  // namespace curveups
