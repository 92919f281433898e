// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <thread>
#include <vector>

namespace curveups {
namespace {

int default_threads() {
  if (const char* text = std::getenv("CURVEUPS_THREADS")) {
    const int count = std::atoi(text);
    if (count > 0) return count;
  }
  return std::max(1u, std::thread::hardware_concurrency());
}

std::atomic<int>& threads() {
  static std::atomic<int> count(default_threads());
  return count;
}

}  // namespace

int thread_count() { return threads(); }

void set_thread_count(int count) { threads() = std::max(1, count); }

void parallel_ranges(int count, const std::function<void(int, int)>& body) {
  const int parts = std::min(thread_count(), count);
  if (parts <= 1) {
    if (count > 0) body(0, count);
    return;
  }
  std::vector<std::exception_ptr> errors(parts);
  auto run = [&](int part) {
    try {
      body(static_cast<int>(static_cast<long long>(count) * part / parts),
           static_cast<int>(static_cast<long long>(count) * (part + 1) / parts));
    } catch (...) {
      errors[part] = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  workers.reserve(parts - 1);
  for (int part = 1; part < parts; ++part) workers.emplace_back(run, part);
  run(0);
  for (std::thread& worker : workers) worker.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

void parallel_pair(const std::function<void()>& a, const std::function<void()>& b) {
  parallel_ranges(2, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) i == 0 ? a() : b();
  });
}

}  // namespace curveups
