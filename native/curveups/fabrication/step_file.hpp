// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP (AP214) with one named, coloured product per body.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/fabrication/print_body.hpp"

namespace curveups {

struct NamedSolid {
  std::string name;
  BodyKind kind;
  TopoDS_Shape shape;
};

// An assembly `title` of all solids, in mm. The same solids give the same bytes: no dates. Nothing
// goes to standard output. Throws IoError, Cancelled.
void write_step(const std::vector<NamedSolid>& solids, const std::string& title,
                const std::string& path, const Progress& progress);

}  // namespace curveups
