// SPDX-License-Identifier: LGPL-2.1-or-later
// A virtual scan as report.json has it.
#pragma once

#include "curveups/bindings/bindings.hpp"
#include "curveups/contact/virtual_scan.hpp"

namespace curveups::bindings {

inline py::dict scan_block(const VirtualScan& scan) {
  py::dict out;
  out["mean_mm"] = scan.mean;
  out["rms_mm"] = scan.rms;
  out["p95_mm"] = scan.p95;
  out["max_mm"] = scan.largest;
  out["hausdorff_mm"] = scan.hausdorff;
  return out;
}

}  // namespace curveups::bindings
