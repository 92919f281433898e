// SPDX-License-Identifier: LGPL-2.1-or-later
// Progress and cancellation of long work.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace curveups {

// Called by long work with its phase and the fraction done (0 to 1, negative: unknown). Returns
// false to stop: the work then returns its best so far with a status, or throws Cancelled where
// there is no partial result. An empty function never stops.
using Progress = std::function<bool(const std::string& what, double fraction)>;

inline bool keep_going(const Progress& progress, const std::string& what, double fraction = -1) {
  return !progress || progress(what, fraction);
}

// Makes a sink for several threads: its calls come one at a time.
inline Progress one_at_a_time(Progress progress) {
  if (!progress) return progress;
  return [progress = std::move(progress), mutex = std::make_shared<std::mutex>()](
             const std::string& what, double fraction) {
    const std::lock_guard<std::mutex> lock(*mutex);
    return progress(what, fraction);
  };
}

}  // namespace curveups
