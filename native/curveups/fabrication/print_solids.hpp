// SPDX-License-Identifier: LGPL-2.1-or-later
// The solids of a print model: built once each, checked, and handed on. No header of OpenCASCADE.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "curveups/fabrication/print_model.hpp"
#include "curveups/fabrication/soundness.hpp"

namespace curveups {

// One compound of the solids of a kind (PrintModel::bodies), in the order of its bodies; kept in
// the model. Several threads may ask at once: the first builds, the others wait. Throws Cancelled.
std::shared_ptr<const TopoDS_Shape> solids_of(const PrintModel& model, const std::string& kind);

// In OpenCASCADE's binary format, as FreeCAD's Part.Shape.importBinary reads it. Throws IoError.
void write_binary_brep(const TopoDS_Shape& shape, const std::string& path);

// Of all bodies of the print. Throws Cancelled.
std::vector<UnsoundSolid> check_solids(const PrintModel& model);

}  // namespace curveups
