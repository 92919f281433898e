// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of a repair: the actuated vertices with all that follows from them, and the layout.
#pragma once

#include <memory>

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// Tiles for vertices where they are, and the layout's constraints on them.
struct Shape {
  DesignGeometry geometry;
  LayoutModel model;  // of that geometry

  // caps: upper bounds of insets besides those of the folds; an inset keeps a little room.
  Shape(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters,
        const Array6& caps);
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
};

// The least room an inset keeps where it is capped, mm.
inline constexpr double least_capped_range = 0.005;

// Copies share the shape.
struct Iterate {
  std::shared_ptr<Shape> shape;
  LayoutState state;

  const DesignGeometry& geometry() const { return shape->geometry; }
  const LayoutModel& model() const { return shape->model; }
  const Points3& vertices() const { return geometry().tiles.mesh.V; }
  FlatPoses poses() const { return poses_of(model(), state); }
  Array6 insets() const { return insets_of(state); }
  // Insets beyond their bounds onto them.
  void keep_pin_bounds();
};

}  // namespace curveups
