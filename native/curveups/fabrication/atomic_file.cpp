// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "curveups/core/errors.hpp"

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
  struct stat info;
  if (::stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode)) fail(path, EISDIR);
  const std::string temporary = path + ".part" + std::to_string(::getpid());
  const int probe = ::open(temporary.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0666);
  if (probe < 0) fail(path, errno);
  ::close(probe);
  try {
    write(temporary);
    const int file = ::open(temporary.c_str(), O_RDWR);
    if (file < 0) fail(path, errno);
    const int synced = ::fsync(file);
    const int reason = errno;
    ::close(file);
    if (synced != 0) fail(path, reason);
    if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, errno);
  } catch (const IoError& error) {
    ::unlink(temporary.c_str());
    // The user knows the final name, not the temporary one.
    std::string what = error.what();
    const std::size_t at = what.find(temporary);
    if (at != std::string::npos) what.replace(at, temporary.size(), path);
    throw IoError(what, error.remedy());
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace curveups
