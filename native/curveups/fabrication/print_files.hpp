// SPDX-License-Identifier: LGPL-2.1-or-later
// The files of a print model. Kinds as in PrintModel::bodies; STL and 3MF know one more, "fused":
// each piece of the print as one closed shell, for print shops that take no overlapping bodies.
#pragma once

#include <string>
#include <vector>

#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// Each writes under a temporary name and renames. Throw IoError, Cancelled.
void write_step(const PrintModel& model, const std::string& kind, const std::string& path);
void write_stl(const PrintModel& model, const std::string& kind, const std::string& path);
void write_3mf(const PrintModel& model, const std::string& kind, const std::string& path);

// A new format is a file that writes it and its value in print_files.cpp.
struct PrintFormat {
  std::string ending;               // of file names, without a dot
  std::vector<std::string> kinds;   // each of which has a file of this format
  std::vector<std::string> wanted;  // those of which print shops ask for it
  void (*write)(const PrintModel& model, const std::string& kind, const std::string& path);
};

// In the order in which a print's files are written.
const std::vector<PrintFormat>& print_formats();
// Throws InvalidInput for an ending that no format has.
const PrintFormat& print_format(const std::string& ending);

}  // namespace curveups
