// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinds of support: what print model, files, report and estimate know of each.
#pragma once

#include <optional>
#include <string>

#include "curveups/bodies/anchors.hpp"
#include "curveups/design/support_kinds.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

struct SupportKind {
  std::string bodies;    // what they are called: "slab", "bridges"; empty where there are none
  std::string material;  // of their bodies in a 3MF
  // As a step of the assembly; "{second}": the side that is glued last.
  std::string removal;
  bool soluble = false;  // of a second material, which a bath takes away; else of the tiles' own
  // Adds its bodies to model.supports, front side up throughout; none where it is null. footprints
  // are those of the pieces. Throws InfeasibleDesign where bodies run into other pieces or are too
  // thin, SolverFailure where an outline falls apart.
  void (*add)(PrintModel& model, const std::vector<PieceFootprint>& footprints) = nullptr;
  // The narrowest place of each of its bodies; null where that depends on the gaps around it.
  ThinFeature (*narrowest)(const Parameters& parameters) = nullptr;
};

// One slab a piece around its tiles and anchors; bridges between the tiles of each contact and from
// anchors to their nearest tiles, which lists what none holds.
#define CURVEUPS_DECLARE(function, name) SupportKind function();
CURVEUPS_SUPPORT_KINDS(CURVEUPS_DECLARE)
#undef CURVEUPS_DECLARE

inline SupportKind no_support() { return {"", "", "", false}; }

// What the parameter `support` asks for.
inline SupportKind support_kind(const Parameters& parameters) {
#define CURVEUPS_PICK(function, name) \
  if (parameters.support == (name)) return function();
  CURVEUPS_SUPPORT_KINDS(CURVEUPS_PICK)
#undef CURVEUPS_PICK
  return no_support();
}

}  // namespace curveups
