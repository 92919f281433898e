// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinds of support. To add one: a line in design/support_kinds.hpp and a file that defines its
// function.
#pragma once

#include <optional>
#include <string>

#include "curveups/bodies/anchors.hpp"
#include "curveups/design/support_kinds.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

struct SupportKind {
  std::string bodies;    // plural name, such as "bridges"; empty: the kind has none
  std::string material;  // name in a 3MF
  std::string removal;   // step of the assembly; "{second}" is replaced by the side glued last
  bool soluble = false;  // true: a second material, which a bath dissolves; else the tiles' own
  // Adds bodies to model.supports, front side up; null: none. footprints: of the pieces. Throws
  // InfeasibleDesign where bodies run into other pieces or are too thin, SolverFailure where an
  // outline falls apart.
  void (*add)(PrintModel& model, const std::vector<PieceFootprint>& footprints) = nullptr;
  // Narrowest place of each body; null where that depends on the gaps around it.
  ThinFeature (*narrowest)(const Parameters& parameters) = nullptr;
};

#define CURVEUPS_DECLARE(function, name) SupportKind function();
CURVEUPS_SUPPORT_KINDS(CURVEUPS_DECLARE)
#undef CURVEUPS_DECLARE

inline SupportKind no_support() { return {"", "", "", false}; }

inline SupportKind support_kind(const Parameters& parameters) {
#define CURVEUPS_PICK(function, name) \
  if (parameters.support == (name)) return function();
  CURVEUPS_SUPPORT_KINDS(CURVEUPS_PICK)
#undef CURVEUPS_PICK
  return no_support();
}

}  // namespace curveups
