// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops over tiles on our own threads. Results never depend on the number of threads: each index
// writes only what is its own, and sums are taken afterwards in the order of the indices.
#pragma once

#include <functional>

namespace curveups {

// Threads for parallel loops; at least 1. Default: the machine's processors, or the environment
// variable CURVEUPS_THREADS where it is a positive number.
int thread_count();
void set_thread_count(int count);

// Calls body(begin, end) on consecutive ranges that cover [0, count). An exception of a range is
// rethrown once all have ended (the one of the lowest range).
void parallel_ranges(int count, const std::function<void(int begin, int end)>& body);

// Runs both, at once where two threads are allowed.
void parallel_pair(const std::function<void()>& a, const std::function<void()>& b);

}  // namespace curveups
