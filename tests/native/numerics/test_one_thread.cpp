// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "curveups/numerics/one_thread.hpp"

extern "C" int openblas_get_num_threads();
extern "C" void openblas_set_num_threads(int);

namespace curveups {
namespace {

TEST(OneThread, GivesBlasItsThreadsBackWhenTheLastGuardGoes) {
  const int given = openblas_get_num_threads();
  openblas_set_num_threads(2);
  const int before = openblas_get_num_threads();
  auto first = std::make_unique<OneThread>();
  EXPECT_EQ(openblas_get_num_threads(), 1);
  std::unique_ptr<OneThread> second;
  std::thread([&] { second = std::make_unique<OneThread>(); }).join();
  first.reset();  // the one that found the number goes before the other
  EXPECT_EQ(openblas_get_num_threads(), 1);
  std::thread([&] { second.reset(); }).join();
  EXPECT_EQ(openblas_get_num_threads(), before);
  openblas_set_num_threads(given);
}

}  // namespace
}  // namespace curveups
