// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/core/platform.hpp"

#include <fcntl.h>

#include <cerrno>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <dlfcn.h>
#include <unistd.h>
#endif

namespace curveups::platform {

#ifdef _WIN32

int process_id() { return _getpid(); }

int sync_file(const std::string& path) {
  const int file = _open(path.c_str(), _O_RDWR | _O_BINARY);
  if (file < 0) return errno;
  const int reason = _commit(file) == 0 ? 0 : errno;
  _close(file);
  return reason;
}

void* loaded_symbol(const std::string&, const char*) { return nullptr; }

#else

int process_id() { return ::getpid(); }

int sync_file(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR);
  if (file < 0) return errno;
  const int reason = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return reason;
}

void* loaded_symbol(const std::string& library, const char* name) {
  void* handle = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (!handle) return nullptr;
  void* symbol = ::dlsym(handle, name);
  ::dlclose(handle);  // NOLOAD counted it up; whoever loaded it keeps it
  return symbol;
}

#endif

}  // namespace curveups::platform
