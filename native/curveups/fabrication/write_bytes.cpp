// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/write_bytes.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "curveups/core/errors.hpp"

namespace curveups {

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  const bool opened = file.is_open();
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return;
  const int reason = errno;
  std::error_code ignored;
  if (opened && std::filesystem::is_regular_file(path, ignored)) {
    std::filesystem::remove(path, ignored);
  }
  throw IoError("can't write " + path + ": " + std::strerror(reason),
                "check that the folder exists, is writable and that the disk has room");
}

}  // namespace curveups
