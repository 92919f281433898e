// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/core/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

constexpr int most_threads = 256;

int default_threads() {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (const char* text = std::getenv("CURVEUPS_THREADS")) {
    const long count = std::strtol(text, nullptr, 10);  // at the ends of long for what is beyond
    if (count > 0) return static_cast<int>(std::min<long>(count, processors));
  }
  return processors;
}

// oneTBB has as many workers as there are processors unless more are asked for.
int allowed(int count) {
  static std::mutex mutex;
  static std::unique_ptr<tbb::global_control> more;
  const std::lock_guard<std::mutex> lock(mutex);
  constexpr auto most = tbb::global_control::max_allowed_parallelism;
  if (static_cast<std::size_t>(count) > tbb::global_control::active_value(most)) {
    more = std::make_unique<tbb::global_control>(most, count);
  }
  return count;
}

std::atomic<int>& threads() {
  static std::atomic<int> count(allowed(default_threads()));
  return count;
}

// True on a thread that works in one of these loops, whose arena limits the threads already.
thread_local bool inside = false;

class Inside {
 public:
  explicit Inside(Watch* watch) : before_(inside), watched_(watch) { inside = true; }
  ~Inside() { inside = before_; }

 private:
  bool before_;
  WatchedBy watched_;
};

// Arena of this thread, kept from loop to loop: making one costs many times a small loop.
tbb::task_arena& own_arena() {
  thread_local std::optional<tbb::task_arena> arena;
  const int count = thread_count();
  if (!arena || arena->max_concurrency() != count) arena.emplace(count);
  return *arena;
}

// Isolated: a thread that waits for its loop takes no other loop's work, which might need a lock
// that it holds.
template <class Work>
void in_arena(const Work& work) {
  if (inside) return tbb::this_task_arena::isolate(work);
  own_arena().execute(work);
}

}  // namespace

int thread_count() { return threads(); }

void set_thread_count(int count) { threads() = allowed(std::clamp(count, 1, most_threads)); }

void parallel_ranges(int count, const std::function<void(int, int)>& body) {
  if (count <= 0) return;
  // Eight ranges a thread balance their costs; more would repeat the bodies' setup.
  const int grain = std::max(1, count / (8 * thread_count()));
  if (thread_count() == 1 || count == 1) {
    for (int begin = 0; begin < count; begin += grain) {
      checkpoint();
      body(begin, std::min(count, begin + grain));
    }
    return;
  }
  std::mutex mutex;
  int lowest = std::numeric_limits<int>::max();
  std::exception_ptr error;
  Watch* const watch = current_watch();
  in_arena([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, count, grain), [&](const auto& range) {
      const Inside guard(watch);
      try {
        checkpoint();
        body(range.begin(), range.end());
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (range.begin() >= lowest) return;
        lowest = range.begin();
        error = std::current_exception();
      }
    });
  });
  if (error) std::rethrow_exception(error);
}

void parallel_each(int count, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::mutex mutex;  // guards `failed` and `error`
  int failed = count;
  std::exception_ptr error;
  parallel_ranges(std::min(count, thread_count()), [&](int, int) {
    for (int i = next++; i < count; i = next++) {
      try {
        checkpoint_at(static_cast<double>(i) / count);
        work(i);
      } catch (...) {
        next = count;
        const std::lock_guard<std::mutex> lock(mutex);
        if (i >= failed) continue;
        failed = i;
        error = std::current_exception();
      }
    }
  });
  if (error) std::rethrow_exception(error);
}

int lane_count() { return thread_count() == 1 ? 1 : 4 * thread_count(); }

void parallel_gather(int count, const std::function<void(int, int, int)>& make,
                     const std::function<void(int, int, int)>& take) {
  auto end_of = [&](int begin) { return std::min(count, begin + gathered_range); };
  if (thread_count() == 1 || count < serial_terms) {
    for (int begin = 0; begin < count; begin += gathered_range) {
      checkpoint();
      make(begin, end_of(begin), 0);
      take(begin, end_of(begin), 0);
    }
    return;
  }
  // At most as many ranges as lanes are in flight, and they end in order: a lane is free before its
  // next range begins.
  const int lanes = lane_count();
  auto lane_of = [&](int begin) { return begin / gathered_range % lanes; };
  int next = 0;
  Watch* const watch = current_watch();
  in_arena([&] {
    tbb::parallel_pipeline(
        lanes, tbb::make_filter<void, int>(tbb::filter_mode::serial_in_order,
                                           [&](tbb::flow_control& control) {
                                             const int begin = next;
                                             if (begin >= count) control.stop();
                                             next += gathered_range;
                                             return begin;
                                           }) &
                   tbb::make_filter<int, int>(tbb::filter_mode::parallel,
                                              [&](int begin) {
                                                const Inside guard(watch);
                                                checkpoint();
                                                make(begin, end_of(begin), lane_of(begin));
                                                return begin;
                                              }) &
                   tbb::make_filter<int, void>(tbb::filter_mode::serial_in_order, [&](int begin) {
                     const Inside guard(watch);
                     take(begin, end_of(begin), lane_of(begin));
                   }));
  });
}

}  // namespace curveups
