// SPDX-License-Identifier: LGPL-2.1-or-later
// A layout away from its start, without symmetry, and so crowded that collision and pin area terms
// are at work: where terms of the layout are tested.
#pragma once

#include <cstdlib>

#include "curveups/layout/initial_layout.hpp"
#include "support/meshes.hpp"

namespace curveups::test {

struct CrowdedLayout {
  explicit CrowdedLayout(const TriangleMesh& mesh)
      : geometry(make_geometry(mesh, Edges(0, 2), parameters)),
        model(make_layout_model(geometry, parameters)) {
    std::srand(11);
    state = initial_layout(model);
    state.leftCols<2>() *= 0.9;
    state += 0.3 * LayoutState::Random(state.rows(), state.cols());
    state.rightCols<6>() =
        state.rightCols<6>().cwiseMax(0.3) + Array6::Constant(state.rows(), 6, 0.4);
  }
  Parameters parameters;
  DesignGeometry geometry;
  LayoutModel model;
  LayoutState state;
};

}  // namespace curveups::test
