// SPDX-License-Identifier: LGPL-2.1-or-later
// Joints: edges along which two pieces are sewn together after printing, through a stitching hole
// on either side, and the room that such a hole needs, in closed form.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/parameters.hpp"
#include "curveups/design/pins.hpp"

namespace curveups {

// An edge of the target with a piece on either side: a cut that parts them.
using Joint = Contact;

// Joints in the order of the edges. Cuts inside of one piece and the target's boundary are none.
std::vector<Joint> find_joints(const TileMesh& tiles);

// Distance of a hole's axis from front edge t in the tile's plane, mm: a round hole of joint_hole
// across, square to the faces, keeps p_floor of material to the wall, which leans by half the fold,
// at every depth. Equal for both tiles of a joint.
double joint_depth(const TileMesh& tiles, const Parameters& parameters, int tile, int t);

// Least inset of a pin's edge t that leaves p_floor of material between the hole and the pin, mm.
double joint_inset(const TileMesh& tiles, const Parameters& parameters, int tile, Side side, int t);

// M x 6 (inset_index): joint_inset and 1 micrometre at joints; 0 elsewhere, and with joint=none.
Array6 joint_insets(const TileMesh& tiles, const Parameters& parameters);

}  // namespace curveups
