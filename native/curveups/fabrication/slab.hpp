// SPDX-License-Identifier: LGPL-2.1-or-later
// Soluble support: one closed slab per piece, put together from faces without any boolean.
#pragma once

#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// outline: the outer loop (counter-clockwise), then holes (clockwise). cavities: what the slab
// surrounds, in print coordinates: tiles that stand on z = 0 with their back pin, of which the
// slab gets the reversed wall, cut, back and back pin faces; their face of role `front` is the
// cavity's mouth, at or below `top`, from which its outline rises upright to `top`. bores: axes
// of round holes through its whole height. Top and bottom are divided into faces without holes
// (add_divided). Throws TopologyError where outlines cross or touch there.
PrintBody make_slab(const std::vector<Polygon>& outline, const std::vector<PrintBody>& cavities,
                    const std::vector<Vec2>& bores, double bore_radius, double top);

}  // namespace curveups
