// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

void work(int milliseconds = 1) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

TEST(Checkpoint, IsNothingWhereNobodyWatches) {
  EXPECT_NO_THROW(checkpoint());
  EXPECT_NO_THROW(checkpoint("alone", 0.5));
}

TEST(Checkpoint, LoopsThatKnowOfNoSinkAskItAndEnd) {
  const int before = thread_count();
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    std::atomic<int> asked{0}, done{0};
    std::string said;
    const ProgressScope scope([&](const std::string& what, double) {
      said = what;
      return ++asked < 3;
    });
    checkpoint("counting", 0.25);
    // Ten seconds and more if nothing stops it.
    EXPECT_THROW(parallel_ranges(10000,
                                 [&](int begin, int end) {
                                   for (int i = begin; i < end; ++i) {
                                     checkpoint();
                                     work();
                                     ++done;
                                   }
                                 }),
                 Cancelled);
    EXPECT_EQ(asked, 3);
    EXPECT_EQ(said, "counting");
    EXPECT_GT(done, 0);
    EXPECT_LT(done, 5000);
    EXPECT_THROW(checkpoint(), Cancelled);  // stopped is stopped
    const Finishing finishing;
    int finished = 0;
    EXPECT_NO_THROW(parallel_gather(
        200, [](int, int, int) {}, [&](int begin, int end, int) { finished += end - begin; }));
    EXPECT_EQ(finished, 200);
  }
  set_thread_count(before);
}

TEST(Checkpoint, LoopsSayHowFarTheyAreAndWaitForNoSink) {
  const int before = thread_count();
  set_thread_count(2);
  std::atomic<int> done{0};
  std::atomic<bool> waited{false};
  std::vector<double> said;
  const ProgressScope scope([&](const std::string&, double fraction) {
    said.push_back(fraction);
    // The second answer comes only when all else is done.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (said.size() == 2 && done < 199 && std::chrono::steady_clock::now() < end) work();
    waited = waited || done == 199;
    return true;
  });
  checkpoint("counting", 0);
  parallel_each(200, [&](int) {
    work();
    ++done;
  });
  EXPECT_EQ(done, 200);
  EXPECT_TRUE(waited);
  ASSERT_GE(said.size(), 2u);
  EXPECT_EQ(said[0], 0);
  EXPECT_GT(said[1], 0);
  EXPECT_LT(said[1], 1);
  set_thread_count(before);
}

TEST(Checkpoint, ASinkIsReachedByOneThreadAtATimeAndTheInnerScopeCounts) {
  const int before = thread_count();
  set_thread_count(4);
  std::atomic<int> inside{0}, together{0}, outer{0};
  const ProgressScope scope([&](const std::string&, double) {
    ++outer;
    return true;
  });
  {
    const ProgressScope inner([&](const std::string&, double) {
      if (++inside > 1) ++together;
      work(2);
      --inside;
      return true;
    });
    const Progress sink = inner.sink();
    parallel_ranges(64, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) EXPECT_TRUE(sink("inner", i / 64.0));
    });
  }
  EXPECT_EQ(together, 0);
  EXPECT_EQ(outer, 0);
  checkpoint("outer");
  EXPECT_EQ(outer, 1);
  set_thread_count(before);
}

}  // namespace
}  // namespace curveups
