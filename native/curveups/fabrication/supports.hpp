// SPDX-License-Identifier: LGPL-2.1-or-later
// The support of a print model; each adds bodies to model.supports. Front side up throughout.
#pragma once

#include "curveups/fabrication/anchors.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// Soluble: one slab a piece around its tiles and anchors; footprints are those of the pieces.
// Throws InfeasibleDesign where slabs run into other pieces, SolverFailure where one falls apart.
void add_slabs(PrintModel& model, const std::vector<PieceFootprint>& footprints);

// Breakaway: bridges between the tiles of each contact and from anchors to their nearest tiles.
// Lists what no bridge holds. Throws what make_bridges throws.
void add_bridges(PrintModel& model, const std::vector<PieceFootprint>& footprints);

// What the parameter `support` asks for. A new kind is a file, its lines here and a choice of the
// parameter.
inline void add_support(PrintModel& model, const std::vector<PieceFootprint>& footprints) {
  if (model.parameters.support == "soluble") add_slabs(model, footprints);
  if (model.parameters.support == "breakaway") add_bridges(model, footprints);
}

}  // namespace curveups
