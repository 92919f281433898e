// SPDX-License-Identifier: LGPL-2.1-or-later
// Holds CHOLMOD and BLAS to one thread while it lives.
#pragma once

namespace curveups {

// CHOLMOD opens an OpenMP team of four for every small supernode whatever OMP_NUM_THREADS says:
// twice as slow on two processors, and sums in an order that varies. OpenBLAS has one number of
// threads for the whole process, which numpy shares: the first guard sets it to one, and the last
// one, on any thread, restores it. The OpenMP part concerns the calling thread alone. Calls of
// either library need a guard.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_;
};

}  // namespace curveups
