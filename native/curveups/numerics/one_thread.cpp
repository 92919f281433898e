// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/one_thread.hpp"

#include <omp.h>

#include <mutex>

extern "C" int openblas_get_num_threads();
extern "C" void openblas_set_num_threads(int);

namespace curveups {
namespace {

// Number of guards, and BLAS threads before the first of them; under the mutex.
std::mutex mutex;
int guards = 0, threads_before = 1;

}  // namespace

// No active levels means teams of one.
OneThread::OneThread() : levels_(omp_get_max_active_levels()) {
  const std::lock_guard<std::mutex> lock(mutex);
  omp_set_max_active_levels(0);
  if (guards++ > 0) return;
  threads_before = openblas_get_num_threads();
  openblas_set_num_threads(1);
}

OneThread::~OneThread() {
  omp_set_max_active_levels(levels_);
  const std::lock_guard<std::mutex> lock(mutex);
  if (--guards == 0) openblas_set_num_threads(threads_before);
}

}  // namespace curveups
