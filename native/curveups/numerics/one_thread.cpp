// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/one_thread.hpp"

#include <omp.h>

#include <mutex>
#include <new>

extern "C" int openblas_get_num_threads();
extern "C" void openblas_set_num_threads(int);

namespace curveups {
namespace {

std::mutex mutex;
// OpenBLAS tries for ever where there is no memory for its buffer (128 MB for each call at once,
// kept from then on): asking for as much before there are more guards than ever makes that an
// error.
constexpr std::size_t buffer_bytes = std::size_t{130} << 20;

// Under the mutex: guards, the most there were, and the threads of BLAS before.
int guards = 0, most_guards = 0, threads_before = 1;

}  // namespace

// No active levels means teams of one.
OneThread::OneThread() : levels_(omp_get_max_active_levels()) {
  const std::lock_guard<std::mutex> lock(mutex);
  if (guards == most_guards) {
    ::operator delete(::operator new(buffer_bytes));
    ++most_guards;
  }
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
