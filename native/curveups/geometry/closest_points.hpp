// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest points of a surface.
#pragma once

#include <memory>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct ClosestPoint {
  Vec3 point;
  int face;
  double distance;
};

// Search tree over the faces of a mesh. Queries are safe from several threads at once.
class ClosestPoints {
 public:
  // mesh: with at least one face.
  explicit ClosestPoints(const TriangleMesh& mesh);
  ~ClosestPoints();

  ClosestPoint operator()(const Vec3& query) const;
  // Unit normal of a face of the mesh; zero where it has no area.
  Vec3 normal(int face) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Distances from each of the points (N x 3) to the surface.
Eigen::VectorXd distances(const Points3& points, const ClosestPoints& surface);

}  // namespace curveups
