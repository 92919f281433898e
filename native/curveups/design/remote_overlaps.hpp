// SPDX-License-Identifier: LGPL-2.1-or-later
// Tiles without a common vertex that overlap all the same when actuated: where the target comes
// nearer to itself than two shells, or a valley is tighter than the body.
#pragma once

#include "curveups/design/contacts.hpp"

namespace curveups {

// Finds them by spatial search and adds to `truncation` a plane (type 4) for each pair, half-way
// between what the two tiles must keep: their front faces and their contact points. Where tiles lie
// so near that contact points have to give way (along slits of the target, say, whose boundary
// walls are upright), the interfaces' back edges are shortened as little as possible, to a quarter
// at most, and `patches` follows; these pairs are listed in truncation.shortened. A pair whose kept
// parts overlap even so goes to truncation.unresolved.
void separate_remote_tiles(const TileMesh& tiles, std::vector<ContactPatch>& patches,
                           Truncation& truncation);

// The same above front faces, where the target comes nearer to itself than two pins are high: pairs
// whose front faces' prisms of height H_pin meet get a plane in truncation.front_pins, across the
// direction in which they overlap least. Planes bound pins; where these have no room, pin_bounds
// names them.
void separate_remote_front_pins(const TileMesh& tiles, double H_pin, Truncation& truncation);

// Whether faces i and j have a vertex in common.
bool share_vertex(const Triangles& F, int i, int j);

}  // namespace curveups
