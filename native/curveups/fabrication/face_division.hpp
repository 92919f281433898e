// SPDX-License-Identifier: LGPL-2.1-or-later
// Large planar faces with many holes as triangles: OpenCASCADE's reader and checker, and what is
// built on them, compare the holes of a face pair by pair.
#pragma once

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// Adds `face`, whose outer loop is a polygon of `body`, as triangles over the body's own points.
// Circles among the holes keep a narrow ring of their own, the only faces with a hole, one each;
// its polygon is of new points. Throws TopologyError where loops cross or touch.
void add_divided(PrintBody& body, const PlanarFace& face);

}  // namespace curveups
