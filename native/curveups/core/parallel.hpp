// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops on oneTBB's threads. Results never depend on the number of
// threads: each index writes its own data, and sums are taken in the order of the indices. Loops
// may be nested.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace curveups {

// Number of threads of parallel loops, at least 1. Default: the machine's processors, or the
// environment variable CURVEUPS_THREADS where it is a positive number below that.
int thread_count();
// Not while a loop runs.
void set_thread_count(int count);

// Loops over fewer cheap terms run on the calling thread: waking another one takes longer.
inline constexpr int serial_terms = 256;

// Calls body(begin, end) on consecutive ranges that cover [0, count). Rethrows the exception of the
// lowest range that failed, once all have ended.
void parallel_ranges(int count, const std::function<void(int begin, int end)>& body);

// Calls work(i) for each index.
template <class Work>
void parallel_for(int count, const Work& work) {
  parallel_ranges(count, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) work(i);
  });
}

// Calls work(i) for each index, taken in their order by whichever thread is free, for work of very
// different costs, and reports the fraction. Rethrows the exception of the lowest index that
// failed; no index is begun after a failure.
void parallel_each(int count, const std::function<void(int i)>& work);

// Gathers results in order: calls `make` on consecutive ranges in parallel, and `take` on the same
// ranges in their order, one at a time, each after its `make`. lane: a number in [0, lane_count())
// that both calls on a range share and no other range has in between, for the data from make to
// take. Ranges have at most gathered_range indices, whatever the number of threads.
inline constexpr int gathered_range = 64;
int lane_count();
void parallel_gather(int count, const std::function<void(int begin, int end, int lane)>& make,
                     const std::function<void(int begin, int end, int lane)>& take);

// Gathers by index: make(index, value) fills in a Value, take(index, value) gathers it.
template <class Value, class Make, class Take>
void parallel_gather(int count, const Make& make, const Take& take) {
  std::vector<std::vector<Value>> values(lane_count());
  for (std::vector<Value>& lane : values) lane.resize(std::min(count, gathered_range));
  parallel_gather(
      count,
      [&](int begin, int end, int lane) {
        for (int i = begin; i < end; ++i) make(i, values[lane][i - begin]);
      },
      [&](int begin, int end, int lane) {
        for (int i = begin; i < end; ++i) take(i, values[lane][i - begin]);
      });
}

// Sum of summand(0), summand(1), ... in this order.
template <class Summand>
double parallel_sum(int count, const Summand& summand) {
  double sum = 0;
  if (count < serial_terms) {
    for (int i = 0; i < count; ++i) sum += summand(i);
    return sum;
  }
  std::vector<double> values(count);
  parallel_ranges(count, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) values[i] = summand(i);
  });
  for (double value : values) sum += value;
  return sum;
}

}  // namespace curveups
