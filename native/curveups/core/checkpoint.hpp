// SPDX-License-Identifier: LGPL-2.1-or-later
// Lets loops stop without a progress sink among their arguments.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "curveups/core/progress.hpp"

namespace curveups {

struct Watch;  // a progress sink and its last answer

// Sets this thread's watch while in scope. parallel.hpp hands it to the threads of a loop.
class WatchedBy {
 public:
  explicit WatchedBy(Watch* watch);
  ~WatchedBy();
  WatchedBy(const WatchedBy&) = delete;
  WatchedBy& operator=(const WatchedBy&) = delete;

 private:
  Watch* before_;
};
Watch* current_watch();

// Makes checkpoint() call this sink, on this thread and in the loops that it runs. The inner one of
// nested scopes counts.
class ProgressScope {
 public:
  explicit ProgressScope(Progress progress);
  ~ProgressScope();
  // The sink for explicit reports: one thread at a time calls it, and none once it has stopped
  // work.
  Progress sink() const;

 private:
  std::unique_ptr<Watch> watch_;
  WatchedBy watched_;
};

// Keeps work with the best so far from being stopped.
class Finishing : WatchedBy {
 public:
  Finishing() : WatchedBy(nullptr) {}
};

// Calls the sink with the last report, unless it was called within some hundredths of a second.
// Throws Cancelled where the sink has stopped the work. Parallel loops call it at every range;
// other long loops call it themselves. Work with a best so far catches Cancelled.
void checkpoint();
// Reports a new phase and its fraction (negative: unknown); always calls the sink.
void checkpoint(const std::string& what, double fraction = -1);
// Updates the fraction of the phase.
void checkpoint_at(double fraction);
// For loops over millions of items: a checkpoint at every 4096th.
inline void checkpoint_now_and_then(std::size_t item) {
  if (item % 4096 == 0) checkpoint();
}

}  // namespace curveups
