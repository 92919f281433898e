// SPDX-License-Identifier: LGPL-2.1-or-later
// Least movement of a surface, in the sense of Eq. 4, sum_j A_j |x_j - c_j|^2, that leaves the pins
// of its tiles room; shared by the smoothing for pins and that of targets. Room is a closed form of
// folds and truncation planes (pin_bounds.hpp), differentiated by the vertices around
// (vertex_patch.hpp); a step is a quadratic program over vertices (least_step.hpp).
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

using PinSide = std::pair<int, Side>;  // tile and its side
using PinSides = std::set<PinSide>;

PinSides sides_of(const std::vector<SmallPin>& pins);

// mm, for each coordinate of a vertex.
struct MoveLimits {
  double step, whole;
};

class ClearanceProgram {
 public:
  // The arguments must outlive this. membranes: these need room, too (membrane_clearance.hpp).
  ClearanceProgram(const TriangleMesh& target, const Edges& cuts, const Parameters& parameters,
                   bool membranes = false);

  // Result of make_geometry; where tiles have no back face, without planes and interfaces of
  // bodies, and shaped is false.
  DesignGeometry geometry(const TriangleMesh& mesh) const;

  // Sum of the room that sides lack, mm: for A_pin_min, in the linear scale of their largest pins,
  // which also measures sides without any room; and under membranes.
  double missing(const DesignGeometry& here) const;

  // Sides of tiles that lack room, with their largest pins.
  std::vector<SmallPin> lacking(const DesignGeometry& here) const;

  // Linearised requirement: the value must stay or become positive.
  struct Row {
    double value;
    std::vector<std::pair<int, Vec3>> by_vertex;  // into `vertices`, with the derivative
  };
  // Requirements on vertices that may move. small: all sides that lack room; lifted: those of them
  // that shall get a little more than they need. Sides with little more keep what they need, sides
  // out of reach what they have, and folds beyond 0.3 rad do not become sharper.
  std::vector<Row> rows(const DesignGeometry& here, const PinSides& small, const PinSides& lifted,
                        const std::vector<int>& vertices) const;

  // Moves vertices of `mesh` towards the least movement from the target that keeps the rows; false
  // where nothing moves any more.
  bool step(const std::vector<Row>& rows, const std::vector<int>& vertices,
            const MoveLimits& limits, TriangleMesh& mesh) const;

 private:
  struct Need;
  struct Gap;
  class Pins;
  // Gaps under membranes of less than `most` times H_pin.
  std::vector<Gap> gaps(const DesignGeometry& here, double most, Pins& pins) const;
  double value(const Need& need, Pins& pins, int at) const;

  const TriangleMesh& target_;
  const Edges& cuts_;
  const Parameters& parameters_;
  bool membranes_;
  Eigen::VectorXd weight_;  // A_j of Eq. 4
  Array3 dihedral_;         // target's folds
};

// Vertices of all tiles that share a vertex with the tiles of these sides.
std::vector<int> vertices_around(const PinSides& sides, const TriangleMesh& mesh);

}  // namespace curveups
