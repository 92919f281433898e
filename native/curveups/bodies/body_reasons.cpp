// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/body_reasons.hpp"

#include <cstdio>

#include "curveups/core/tolerances.hpp"
#include "curveups/design/tile_mesh.hpp"

namespace curveups {
namespace {

std::string between(const PairFigure& figure) {
  return figure.tiles[0] < 0
             ? ""
             : " (" + tile_name(figure.tiles[0]) + ", " + tile_name(figure.tiles[1]) + ")";
}

}  // namespace

std::vector<std::string> body_reasons(const PairFigure& flat, const PairFigure& actuated) {
  std::vector<std::string> reasons;
  // The distance of bodies that overlap is 0 as well.
  if (flat.value <= 0) reasons.push_back("solids meet in the flat layout" + between(flat));
  if (actuated.value > tolerance::overlap_volume) {
    char text[80];
    std::snprintf(text, sizeof text, "actuated tiles overlap by %.3g mm3", actuated.value);
    reasons.push_back(text + between(actuated));
  }
  return reasons;
}

}  // namespace curveups
