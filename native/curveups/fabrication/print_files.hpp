// SPDX-License-Identifier: LGPL-2.1-or-later
// The files of a print model. Kinds as in PrintModel::bodies.
#pragma once

#include <string>

#include "curveups/core/progress.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// Each writes under a temporary name and renames. Throw IoError, Cancelled.
void write_step(const PrintModel& model, const std::string& kind, const std::string& path,
                const Progress& progress);
void write_stl(const PrintModel& model, const std::string& kind, const std::string& path,
               const Progress& progress);
void write_3mf(const PrintModel& model, const std::string& path, const Progress& progress);

}  // namespace curveups
