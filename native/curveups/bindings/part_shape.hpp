// SPDX-License-Identifier: LGPL-2.1-or-later
// An OpenCASCADE shape as FreeCAD's Part.Shape.
#pragma once

#include "curveups/bindings/bindings.hpp"

class TopoDS_Shape;

namespace curveups::bindings {

// Without a copy on Linux, where FreeCAD's Part module exports its own conversion (0.20 and 1.0
// do), else through its binary exchange format in a temporary file: the
// same shape, in seconds instead of microseconds. Imports Part, and raises ImportError without
// FreeCAD.
py::object to_part_shape(const TopoDS_Shape& shape);

}  // namespace curveups::bindings
