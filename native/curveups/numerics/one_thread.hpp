// SPDX-License-Identifier: LGPL-2.1-or-later
// Holds CHOLMOD and BLAS to one thread while it lives.
#pragma once

namespace curveups {

// CHOLMOD opens an OpenMP team of four for every small supernode whatever OMP_NUM_THREADS says:
// twice as slow on two processors, and sums in an order that varies. OpenBLAS has threads of its
// own, one number for the whole process, which it shares with numpy: the first guard sets it to
// one, the last to go, on whichever thread, puts back what was there. The OpenMP part works on the
// calling thread alone. To be put around every call that ends in them.
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
