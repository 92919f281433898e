// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/core/one_thread.hpp"

#include <omp.h>

extern "C" void openblas_set_num_threads(int);

namespace curveups {

// No active levels means teams of one.
OneThread::OneThread() : levels_(omp_get_max_active_levels()) {
  omp_set_max_active_levels(0);
  openblas_set_num_threads(1);
}

OneThread::~OneThread() { omp_set_max_active_levels(levels_); }

}  // namespace curveups
