// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

TEST(Parallel, RangesCoverEveryIndexOnce) {
  const int before = thread_count();
  for (int threads : {1, 2, 5}) {
    set_thread_count(threads);
    for (int count : {0, 1, 2, 7, 1000}) {
      std::vector<int> visits(count, 0);
      parallel_ranges(count, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), count);
      for (int v : visits) EXPECT_EQ(v, 1);
    }
  }
  set_thread_count(before);
}

TEST(Parallel, TheExceptionOfTheLowestIndexComesOutAndNoMoreIsBegun) {
  const int before = thread_count();
  const auto fail_from = [](int first) {
    return [first](int i) {
      if (i >= first) throw std::runtime_error(std::to_string(i));
    };
  };
  const auto expect = [](const char* message, const auto& loop) {
    try {
      loop();
      ADD_FAILURE();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), message);
    }
  };
  for (int threads : {1, 4}) {
    set_thread_count(threads);
    expect("1", [&] { parallel_for(4, fail_from(1)); });
    std::atomic<int> begun{0};
    expect("10", [&] {
      parallel_each(10000, [&](int i) {
        ++begun;
        // The second one fails before the first one does.
        if (i == 10) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        fail_from(10)(i);
      });
    });
    EXPECT_LT(begun, 10000);
  }
  set_thread_count(before);
}

TEST(Parallel, LoopsOfSeveralThreadsBearErrorsAndOtherNumbersOfThreads) {
  const int before = thread_count();
  for (int threads : {3, 1, 4, 2}) {
    set_thread_count(threads);
    std::array<int, 2> sums{}, errors{};
    auto work = [&](int k) {
      for (int round = 0; round < 20; ++round) {
        std::atomic<int> sum{0};
        parallel_each(100, [&](int i) { sum += i; });
        sums[k] += sum;
        try {
          parallel_each(10, [&](int i) {
            if (i == 3) throw std::runtime_error("3");
          });
        } catch (const std::runtime_error&) {
          ++errors[k];
        }
      }
    };
    std::thread one(work, 0), other(work, 1);
    one.join();
    other.join();
    EXPECT_EQ(sums, (std::array<int, 2>{99000, 99000}));
    EXPECT_EQ(errors, (std::array<int, 2>{20, 20}));
  }
  set_thread_count(before);
}

TEST(Parallel, EachIndexIsTakenOnceByWhoeverIsFree) {
  const int before = thread_count();
  for (int threads : {1, 2, 5}) {
    set_thread_count(threads);
    for (int count : {0, 1, 2, 7, 1000}) {
      std::vector<int> visits(count, 0);
      parallel_each(count, [&](int i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
  // Long work keeps no other from being done meanwhile.
  set_thread_count(2);
  std::atomic<int> done{0};
  parallel_each(100, [&](int i) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (i == 0 && done < 99 && std::chrono::steady_clock::now() < end) {
      std::this_thread::yield();
    }
    if (i == 0) {
      EXPECT_EQ(done, 99);
    }
    ++done;
  });
  set_thread_count(before);
}

// Terms of very different sizes: any other order of summation gives other digits.
double awkward(int i) { return std::ldexp(1.0 + 1.0 / (i + 3), (7 * i) % 40 - 20); }

TEST(Parallel, SumsAreThoseOfAPlainLoopWithAnyNumberOfThreads) {
  const int before = thread_count();
  for (int count : {0, 1, 63, 64, 65, 5000}) {
    double expected = 0;
    for (int i = 0; i < count; ++i) expected += awkward(i);
    for (int threads : {1, 2, 3, 4, 8}) {
      set_thread_count(threads);
      EXPECT_EQ(parallel_sum(count, awkward), expected);
      double gathered = 0;
      std::vector<int> order;
      parallel_gather<double>(
          count, [](int i, double& value) { value = awkward(i); },
          [&](int i, double value) {
            gathered += value;
            order.push_back(i);
          });
      EXPECT_EQ(gathered, expected);
      EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
      EXPECT_EQ(static_cast<int>(order.size()), count);
    }
  }
  set_thread_count(before);
}

// Also where there are fewer processors.
TEST(Parallel, AsManyThreadsWorkAsAreAskedFor) {
  const int before = thread_count();
  set_thread_count(4);
  std::atomic<int> arrived{0};
  const auto meet = [&] {
    ++arrived;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (arrived < 4 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    EXPECT_EQ(arrived, 4);
  };
  parallel_for(4, [&](int) { meet(); });
  set_thread_count(before);
}

TEST(Parallel, LoopsMayBeNested) {
  const int before = thread_count();
  set_thread_count(4);
  std::vector<double> sums(20);
  parallel_ranges(20, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      parallel_gather<double>(
          500, [&](int i, double& value) { value = awkward(i + k); },
          [&](int, double value) { sums[k] += value; });
    }
  });
  for (int k = 0; k < 20; ++k) {
    double expected = 0;
    for (int i = 0; i < 500; ++i) expected += awkward(i + k);
    EXPECT_EQ(sums[k], expected);
  }
  set_thread_count(before);
}

}  // namespace
}  // namespace curveups
