// SPDX-License-Identifier: LGPL-2.1-or-later
// Small pictures for file managers and slicers.
#pragma once

#include <string>
#include <vector>

#include "curveups/fabrication/body_mesh.hpp"

namespace curveups {

// A square PNG on a transparent ground: bodies in their colours (palette.hpp), lit, seen obliquely
// from above. The same meshes give the same bytes. Empty without triangles.
std::string draw_thumbnail(const std::vector<BodyMesh>& meshes);

}  // namespace curveups
