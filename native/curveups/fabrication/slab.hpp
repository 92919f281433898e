// SPDX-License-Identifier: LGPL-2.1-or-later
// Soluble support: one closed slab per piece, assembled from faces without booleans.
#pragma once

#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// outline: the outer loop (counter-clockwise), then holes (clockwise). cavities: tiles inside of
// the slab, in print coordinates, standing on z = 0 with their back pin. The slab gets their
// reversed wall, cut, back and back pin faces; from the outline of the front face, at or below
// `top`, the cavity rises upright to `top`. bores: axes of round holes through the slab. Top and
// bottom consist of triangles, but for rings around bores. Throws TopologyError where outlines
// cross or touch.
PrintBody make_slab(const std::vector<Polygon>& outline, const std::vector<PrintBody>& cavities,
                    const std::vector<Vec2>& bores, double bore_radius, double top);

}  // namespace curveups
