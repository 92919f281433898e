// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/body_reasons.hpp"

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

Finding of(const char* kind, const PairFigure& figure) {
  const Finding::Pairs pair = {figure.tiles};
  return {kind, tiles_of(pair), {{"value", figure.value}, {"at", tiles_of(pair)}}};
}

}  // namespace

std::vector<Finding> body_reasons(const PairFigure& flat, const PairFigure& actuated) {
  std::vector<Finding> reasons;
  // The distance of bodies that overlap is 0 as well.
  if (flat.value <= 0) reasons.push_back(of("bodies_meet", flat));
  if (actuated.value > tolerance::overlap_volume) reasons.push_back(of("bodies_overlap", actuated));
  return reasons;
}

}  // namespace curveups
