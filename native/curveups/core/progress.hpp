// SPDX-License-Identifier: LGPL-2.1-or-later
// Progress and cancellation of long work.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace curveups {

// Called by long work now and then: what is being done, and how much of it (0 to 1, negative where
// it can't be known). Returns false to stop: the work then returns the best it has, with its status
// saying so, or throws Cancelled where there is no partial result. An empty function never stops.
using Progress = std::function<bool(const std::string& what, double fraction)>;

inline bool keep_going(const Progress& progress, const std::string& what, double fraction = -1) {
  return !progress || progress(what, fraction);
}

// The same for several threads: its calls come one at a time.
inline Progress one_at_a_time(Progress progress) {
  if (!progress) return progress;
  return [progress = std::move(progress), mutex = std::make_shared<std::mutex>()](
             const std::string& what, double fraction) {
    const std::lock_guard<std::mutex> lock(*mutex);
    return progress(what, fraction);
  };
}

}  // namespace curveups
