// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes a whole file at once.
#pragma once

#include <string>

namespace curveups {

// Throws IoError naming the path and the system's reason; a file that was begun is removed then.
void write_bytes(const std::string& path, const std::string& bytes);

}  // namespace curveups
