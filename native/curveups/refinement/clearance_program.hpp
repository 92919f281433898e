// SPDX-License-Identifier: LGPL-2.1-or-later
// The least movement of a surface, in the sense of Eq. 4, sum_j A_j |x_j - c_j|^2, that leaves the
// pins of its tiles room: what the smoothing for pins and that of targets have in common. Room
// is a closed form of folds and truncation planes (pin_bounds.hpp), differentiated by the vertices
// around (vertex_patch.hpp); a step is a quadratic program over vertices (least_step.hpp).
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

using PinSide = std::pair<int, Side>;  // of a tile
using PinSides = std::set<PinSide>;

PinSides sides_of(const std::vector<SmallPin>& pins);

// mm, for each coordinate of a vertex.
struct MoveLimits {
  double step, whole;
};

class ClearanceProgram {
 public:
  // The arguments must outlive this. membranes: whether they need room, too
  // (membrane_clearance.hpp).
  ClearanceProgram(const TriangleMesh& target, const Edges& cuts, const Parameters& parameters,
                   bool membranes = false);

  // As make_geometry; where tiles have no back face, without what follows from bodies (planes,
  // interfaces): shaped is then false.
  DesignGeometry geometry(const TriangleMesh& mesh) const;

  // What all sides together lack of room, mm: for A_pin_min, of the linear scale of their largest
  // pins, which says of sides without any room, too, by how much they miss it; and under membranes.
  double missing(const DesignGeometry& here) const;

  // Sides of tiles that lack room, with their largest pins; each once.
  std::vector<SmallPin> lacking(const DesignGeometry& here) const;

  // A requirement, linearised: the value must stay or become positive.
  struct Row {
    double value;
    std::vector<std::pair<int, Vec3>> by_vertex;  // into `vertices`, with the derivative
  };
  // What vertices that may move have to mind. small: all sides that lack room; asked: those of them
  // that are to get a little more than they need. Sides with little more keep what they need, those
  // out of reach what they have, and folds beyond 0.3 rad do not become sharper.
  std::vector<Row> rows(const DesignGeometry& here, const PinSides& small, const PinSides& asked,
                        const std::vector<int>& vertices) const;

  // Moves vertices of `mesh` towards the least movement from the target that keeps the rows; false
  // where nothing moves any more.
  bool step(const std::vector<Row>& rows, const std::vector<int>& vertices,
            const MoveLimits& limits, TriangleMesh& mesh) const;

 private:
  struct Need;
  struct Gap;
  class Pins;
  // Under membranes, those of less than `most` times H_pin.
  std::vector<Gap> gaps(const DesignGeometry& here, double most, Pins& pins) const;
  double value(const Need& need, Pins& pins, int at) const;

  const TriangleMesh& target_;
  const Edges& cuts_;
  const Parameters& parameters_;
  bool membranes_;
  Eigen::VectorXd weight_;  // A_j of Eq. 4
  Array3 dihedral_;         // of the target
};

// The vertices of the tiles around these: of all tiles that share a vertex with one of theirs.
std::vector<int> vertices_around(const PinSides& sides, const TriangleMesh& mesh);

}  // namespace curveups
