// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes files that exist completely or not at all.
#pragma once

#include <functional>
#include <string>

namespace curveups {

// Calls write(temporary), which writes to that path beside `path`; then makes sure that the data is
// on the disk and renames. On any failure the temporary file is removed and what was at `path`
// stays. Throws IoError naming the path and the system's reason, and where something stands there
// that is no regular file; passes on what `write` throws.
void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary)>& write);

// Writes bytes to a file; throws IoError.
void write_bytes(const std::string& path, const std::string& bytes);

}  // namespace curveups
