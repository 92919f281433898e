// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid motions of whole pieces on the print bed.
#pragma once

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// Turn each piece to its smallest bounding rectangle (the longer side along x) and put the pieces
// in rows, `margin` mm around each, so that the whole is about as wide as high; centred on the
// origin.
FlatPoses arrange_pieces(const TileMesh& tiles, const FlatPoses& poses, double margin);

}  // namespace curveups
