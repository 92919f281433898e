// SPDX-License-Identifier: LGPL-2.1-or-later
// Prepares shapes so that BRepCheck is fastest.
#pragma once

#include <TopoDS_Shape.hxx>

namespace curveups {

// A copy of a shape whose edges have a curve in the parameters of each plane that they bound. Edges
// on planes need none, and those of our solids have none: OpenCASCADE projects them whenever it is
// asked for one, which was a quarter of a check's time. Here each is that same projection, made
// once. Curves and surfaces are those of the shape itself, which stays as it is, bit for bit:
// others may read it meanwhile.
TopoDS_Shape with_plane_curves(const TopoDS_Shape& shape);

}  // namespace curveups
