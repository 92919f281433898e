// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "curveups/core/errors.hpp"
#include "curveups/core/platform.hpp"

namespace curveups {
namespace {

[[noreturn]] void fail(const std::string& path, int reason) {
  throw IoError("can't write " + path + ": " + std::strerror(reason),
                "check that the folder exists, is writable and that the disk has room");
}

}  // namespace

void write_bytes(const std::string& path, const std::string& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) fail(path, errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int reason = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written) fail(path, reason);
  if (!closed) fail(path, errno);
}

void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary)>& write) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  // What C's functions take for the end of the name.
  if (path.find('\0') != std::string::npos) fail(path.c_str(), EINVAL);
  if (fs::is_directory(path, ignored)) fail(path, EISDIR);
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    throw IoError("can't write " + path + ": it is a device, and a rename would replace it",
                  "name a file");
  }
  const std::string temporary = path + ".part" + std::to_string(platform::process_id());
  try {
    write_bytes(temporary, "");
    write(temporary);
    if (const int reason = platform::sync_file(temporary)) fail(path, reason);
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error) fail(path, error.value());
  } catch (const IoError& error) {
    fs::remove(temporary, ignored);
    // The user knows the final name, not the temporary one.
    std::string what = error.what();
    const std::size_t at = what.find(temporary);
    if (at != std::string::npos) what.replace(at, temporary.size(), path);
    throw IoError(what, error.remedy());
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
}

}  // namespace curveups
