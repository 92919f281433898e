// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary loops of a surface as closed polylines.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

class BoundaryCurves {
 public:
  explicit BoundaryCurves(const TriangleMesh& mesh);

  int count() const { return static_cast<int>(curves_.size()); }
  double length(int curve) const { return curves_[curve].arc.back(); }
  // Vertices of the mesh at which its boundary turns by more than `angle` (rad).
  std::vector<int> corners(double angle) const;

  struct Place {
    int curve;
    double arc;  // from the loop's first vertex
    double distance;
  };
  Place nearest(const Vec3& p) const;
  // arc is taken modulo the length.
  Vec3 at(int curve, double arc) const;

 private:
  struct Curve {
    std::vector<int> vertex;
    std::vector<Vec3> point;  // the first again at the end
    std::vector<double> arc;
  };
  std::vector<Curve> curves_;
};

}  // namespace curveups
