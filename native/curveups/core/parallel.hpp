// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops on oneTBB's threads, made once and shared with OpenCASCADE. Results never depend on the
// number of threads: each index writes only what is its own, and sums are taken in the order of the
// indices. Loops may be nested.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace curveups {

// Threads for parallel loops; at least 1. Default: the machine's processors, or the environment
// variable CURVEUPS_THREADS where it is a positive number below that.
int thread_count();
// Not while a loop runs.
void set_thread_count(int count);

// The thread that asks works off fewer cheap terms than this: waking another thread takes longer,
// and the system may have put that one aside.
inline constexpr int serial_terms = 256;

// Calls body(begin, end) on consecutive ranges that cover [0, count). An exception of a range is
// rethrown once all have ended (the one of the lowest range).
void parallel_ranges(int count, const std::function<void(int begin, int end)>& body);

// The same by index: work(i).
template <class Work>
void parallel_for(int count, const Work& work) {
  parallel_ranges(count, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) work(i);
  });
}

// work(i) for each index, taken in their order by whichever thread is free: for work that costs now
// this and now a thousand times as much. Of several that fail, the first one's exception is thrown.
void parallel_each(int count, const std::function<void(int i)>& work);

// Runs all, at once where there are threads; exceptions as of ranges.
void parallel_tasks(const std::vector<std::function<void()>>& tasks);

// A loop whose results are gathered one after another: `make` on consecutive ranges at once, `take`
// on the same ranges in their order, one at a time, each after its `make`. lane: the same number in
// [0, lane_count()) for both calls on a range, and no other range's in between: where make leaves
// what take gathers. Ranges have at most gathered_range indices, whatever the number of threads.
inline constexpr int gathered_range = 64;
int lane_count();
void parallel_gather(int count, const std::function<void(int begin, int end, int lane)>& make,
                     const std::function<void(int begin, int end, int lane)>& take);

// The same by index: make(index, value) fills in a Value, take(index, value) gathers it.
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

// The sum of term(0), term(1), ... in this order.
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
