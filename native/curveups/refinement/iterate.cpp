// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/iterate.hpp"

namespace curveups {

Shape::Shape(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters,
             const Array6& caps)
    : geometry(make_geometry(mesh, cuts, parameters)),
      model(make_layout_model(geometry, parameters)) {
  PinBounds& bounds = geometry.pin_bounds;
  bounds.upper =
      bounds.upper.cwiseMin(caps.cwiseMax((bounds.lower.array() + least_capped_range).matrix()));
}

void Iterate::keep_pin_bounds() {
  const PinBounds& bounds = geometry().pin_bounds;
  state.rightCols<6>() = state.rightCols<6>().cwiseMax(bounds.lower).cwiseMin(bounds.upper);
}

}  // namespace curveups
