// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of a repair: the actuated vertices with all that follows from them, and the layout.
#pragma once

#include <memory>

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// Tiles on a mesh, and the layout's constraints on them. The model refers to the geometry.
struct Shape {
  DesignGeometry geometry;
  LayoutModel model;

  Shape(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters)
      : geometry(make_geometry(mesh, cuts, parameters)),
        model(make_layout_model(geometry, parameters)) {}
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
};

// Copies share the shape.
struct Iterate {
  std::shared_ptr<Shape> shape;
  LayoutState state;

  const DesignGeometry& geometry() const { return shape->geometry; }
  const LayoutModel& model() const { return shape->model; }
  const Points3& vertices() const { return geometry().tiles.mesh.V; }
  FlatPoses poses() const { return poses_of(model(), state); }
  Array6 insets() const { return insets_of(state); }
  // Moves insets beyond their bounds onto them.
  void keep_pin_bounds() {
    const PinBounds& bounds = geometry().pin_bounds;
    state.rightCols<6>() = state.rightCols<6>().cwiseMax(bounds.lower).cwiseMin(bounds.upper);
  }
};

}  // namespace curveups
