// SPDX-License-Identifier: LGPL-2.1-or-later
// Hides the differences between Linux, macOS and Windows.
#pragma once

#include <string>

namespace curveups::platform {

int process_id();

// Waits until what was written to the file is on the disk. 0, or the system's error number.
int sync_file(const std::string& path);

// The address of a symbol of a library that the process has loaded from this file; null where it is
// not there, and always on Windows, which has other mangled names.
void* loaded_symbol(const std::string& library, const char* name);

}  // namespace curveups::platform
