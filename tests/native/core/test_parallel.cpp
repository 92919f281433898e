// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
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

TEST(Parallel, TheExceptionOfTheLowestRangeComesOut) {
  const int before = thread_count();
  set_thread_count(4);
  try {
    parallel_ranges(4, [](int begin, int) {
      if (begin > 0) throw std::runtime_error(std::to_string(begin));
    });
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "1");
  }
  set_thread_count(before);
}

TEST(Parallel, PairRunsBoth) {
  int a = 0, b = 0;
  parallel_pair([&] { a = 1; }, [&] { b = 2; });
  EXPECT_EQ(a + b, 3);
}

}  // namespace
}  // namespace curveups
