// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/core/checkpoint.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {

struct Watch {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds interval{40};

  explicit Watch(Progress sink) : progress(std::move(sink)) {}

  bool say(const std::string& doing, double share) {
    const std::lock_guard<std::mutex> lock(mutex);
    what = doing;
    fraction = share;
    return ask();
  }
  // With the mutex held.
  bool ask() {
    if (stopped) return false;
    if (!keep_going(progress, what, fraction)) stopped = true;
    asked = Clock::now().time_since_epoch().count();
    return !stopped;
  }
  bool due() const {
    return Clock::now().time_since_epoch() - Clock::duration(asked.load()) > interval;
  }

  Progress progress;
  std::mutex mutex;  // guards all that is not atomic
  std::string what = "working";
  double fraction = -1;
  std::atomic<bool> stopped{false};
  std::atomic<Clock::rep> asked{Clock::now().time_since_epoch().count()};
};

namespace {

thread_local Watch* current = nullptr;

// Calls the sink if that is due and no other thread does. fraction: a new one, or null.
void ask_now_and_then(const double* fraction) {
  Watch* watch = current;
  if (!watch) return;
  if (!watch->stopped) {
    if (!watch->due()) return;
    const std::unique_lock<std::mutex> lock(watch->mutex, std::try_to_lock);
    if (!lock) return;
    if (fraction) watch->fraction = *fraction;
    if (watch->ask()) return;
  }
  throw Cancelled();
}

}  // namespace

ProgressScope::ProgressScope(Progress progress)
    : watch_(std::make_unique<Watch>(std::move(progress))), watched_(watch_.get()) {}
ProgressScope::~ProgressScope() = default;

Progress ProgressScope::sink() const {
  return [watch = watch_.get()](const std::string& what, double fraction) {
    return watch->say(what, fraction);
  };
}

void checkpoint() { ask_now_and_then(nullptr); }

void checkpoint_at(double fraction) { ask_now_and_then(&fraction); }

void checkpoint(const std::string& what, double fraction) {
  Watch* watch = current;
  if (watch && !watch->say(what, fraction)) throw Cancelled();
}

Watch* current_watch() { return current; }

WatchedBy::WatchedBy(Watch* watch) : before_(std::exchange(current, watch)) {}
WatchedBy::~WatchedBy() { current = before_; }

}  // namespace curveups
