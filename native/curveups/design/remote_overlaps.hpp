// SPDX-License-Identifier: LGPL-2.1-or-later
// Tiles without a common vertex that overlap all the same when actuated: where the target comes
// nearer to itself than two shells, or a valley is tighter than the body.
#pragma once

#include "curveups/design/contacts.hpp"

namespace curveups {

// Finds them by spatial search and adds to `truncation` a plane (type 4) for each pair, half-way
// between what the two tiles must keep: their front faces and their contact points. A pair whose
// kept parts overlap themselves goes to truncation.unresolved. Changes no contact patch.
void separate_remote_tiles(const TileMesh& tiles, const std::vector<ContactPatch>& patches,
                           Truncation& truncation);

}  // namespace curveups
