// SPDX-License-Identifier: LGPL-2.1-or-later
// Lets loops stop without knowing who waits for them.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "curveups/core/progress.hpp"

namespace curveups {

struct Watch;  // a progress sink, when it was asked last, and what it answered

// While in scope, checkpoint() asks this sink on this thread and in the loops that it runs
// (parallel.hpp). Scopes nest: the inner one counts.
class ProgressScope {
 public:
  explicit ProgressScope(Progress progress);
  ~ProgressScope();
  ProgressScope(const ProgressScope&) = delete;
  ProgressScope& operator=(const ProgressScope&) = delete;
  // For those who say what is being done: one thread at a time reaches the sink, and no more does
  // once it has stopped the work.
  Progress sink() const;

 private:
  std::unique_ptr<Watch> watch_;
  Watch* before_;
};

// Cheap; asks the sink, with what was said last, where that was some hundredths of a second ago.
// Throws Cancelled where the sink has stopped the work. Called at the beginning of every range of
// parallel loops, and by long loops that are none. Work with a best so far catches Cancelled.
void checkpoint();
// The same, saying what is being done and how much of it: for phases, as it asks every time.
void checkpoint(const std::string& what, double fraction = -1);
// As checkpoint(), with how much is done by now.
void checkpoint_at(double fraction);
// For loops over millions of items: at every 4096th.
inline void checkpoint_now_and_then(std::size_t item) {
  if (item % 4096 == 0) checkpoint();
}

// While in scope nothing is stopped: for what remains to be done with the best so far.
class Finishing {
 public:
  Finishing();
  ~Finishing();
  Finishing(const Finishing&) = delete;
  Finishing& operator=(const Finishing&) = delete;

 private:
  Watch* before_;
};

// For loops on other threads: what this thread is watched by, and that for the time of a scope.
Watch* current_watch();
class WatchedBy {
 public:
  explicit WatchedBy(Watch* watch);
  ~WatchedBy();
  WatchedBy(const WatchedBy&) = delete;
  WatchedBy& operator=(const WatchedBy&) = delete;

 private:
  Watch* before_;
};

}  // namespace curveups
