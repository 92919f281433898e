// SPDX-License-Identifier: LGPL-2.1-or-later
// The volume that a solid's faces enclose, from OpenCASCADE's surfaces and curves alone.
#pragma once

#include <TopoDS_Shape.hxx>

namespace curveups {

// mm3; negative where faces are turned over. The sum of what faces span with a point: in closed
// form of plane faces between lines and circles and of whole belts of spheres and cylinders, by
// BRepGProp's integrals of any other.
double solid_volume(const TopoDS_Shape& shape);

}  // namespace curveups
