// SPDX-License-Identifier: LGPL-2.1-or-later
// Overlaps of actuated tiles without a common vertex: where the target comes nearer to itself than
// two shells, or a valley is tighter than the body.
#pragma once

#include "curveups/design/contacts.hpp"

namespace curveups {

// Add to `truncation` a plane (type 4) for each pair, half-way between the parts that the two tiles
// must keep: their front faces and contact points. Where these overlap (along slits of the target,
// say, whose boundary walls are upright), the interfaces' back edges are shortened as little as
// possible, to a quarter at most, and `patches` follows; truncation.shortened lists these pairs. A
// pair whose kept parts overlap even so goes to truncation.unresolved.
void separate_remote_tiles(const TileMesh& tiles, std::vector<ContactPatch>& patches,
                           Truncation& truncation);

// Add planes above front faces, where the target comes nearer to itself than two pins are high:
// pairs whose front faces' prisms of height H_pin overlap get one in truncation.front_pins, across
// the direction of least overlap. These planes bound pins alone.
void separate_remote_front_pins(const TileMesh& tiles, double H_pin, Truncation& truncation);

// True where faces i and j have a vertex in common.
bool share_vertex(const Triangles& F, int i, int j);

}  // namespace curveups
