// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids of a print model: built once each, checked and written. No header of OpenCASCADE.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// Returns a compound of the solids of a kind (PrintModel::bodies), in the order of its bodies; the
// model keeps it. Threads that ask while another one builds wait. Throws Cancelled, SolverFailure.
std::shared_ptr<const TopoDS_Shape> solids_of(const PrintModel& model, const std::string& kind);

// Writes OpenCASCADE's binary format, as FreeCAD's Part.Shape.importBinary reads it. Throws
// IoError.
void write_binary_brep(const TopoDS_Shape& shape, const std::string& path);

// Reason: BRepCheck, an open shell, or a volume that differs from the analytic one by more than
// 1e-9 of it.
struct UnsoundSolid {
  std::string body, reason;
  int tile = -1;  // PrintBody::tile
};

// Unsound solids in the order of the bodies. Throws Cancelled, and SolverFailure where OpenCASCADE
// fails.
std::vector<UnsoundSolid> check_solids(const std::vector<const PrintBody*>& bodies,
                                       const std::vector<TopoDS_Shape>& solids);
std::vector<UnsoundSolid> check_solids(const PrintModel& model);  // all bodies of the print

// Why unsound solids make a design not valid; empty where there are none.
std::vector<Finding> solid_reasons(const std::vector<UnsoundSolid>& unsound);

}  // namespace curveups
