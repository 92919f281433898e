// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of a print model. Kinds as in PrintModel::bodies; STL and 3MF have one more, "fused": each
// piece of the print as one closed shell, for print shops that take no overlapping bodies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// title: stands inside of the file; by default the model's name. Throw IoError, Cancelled.
using Title = std::optional<std::string>;
void write_step(const PrintModel& model, const std::string& kind, const std::string& path,
                const Title& title = {});
void write_stl(const PrintModel& model, const std::string& kind, const std::string& path,
               const Title& title = {});
void write_3mf(const PrintModel& model, const std::string& kind, const std::string& path,
               const Title& title = {});

// To add a format: a file that writes it and its value in print_files.cpp.
struct PrintFormat {
  std::string ending;               // without a dot
  std::vector<std::string> kinds;   // with a file of this format each
  std::vector<std::string> wanted;  // kinds that print shops ask for
  void (*write)(const PrintModel& model, const std::string& kind, const std::string& path,
                const Title& title);
};

// All formats, in the order in which a print's files are written.
const std::vector<PrintFormat>& print_formats();
// Throws InvalidInput for an ending that no format has.
const PrintFormat& print_format(const std::string& ending);

}  // namespace curveups
