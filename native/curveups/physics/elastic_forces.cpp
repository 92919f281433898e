// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/elastic_forces.hpp"

namespace curveups {

Points3 tile_centres(const TileMesh& tiles) {
  Points3 centres(tiles.tile_count(), 3);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const auto corners = tiles.mesh.F.row(i);
    centres.row(i) = (tiles.mesh.V.row(corners(0)) + tiles.mesh.V.row(corners(1)) +
                      tiles.mesh.V.row(corners(2))) /
                     3;
  }
  return centres;
}

Points3 pin_corner_forces(const MembraneMesh& mesh, const MembraneState& state, int tile_count) {
  Points3 forces = Points3::Zero(3 * tile_count, 3);
  const CornerWeights& w = mesh.weights;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.pin[v] < 0) continue;
    for (int k = w.start[v]; k < w.start[v + 1]; ++k) {
      forces.row(w.corner[k]) -= w.weight[k] * state.gradient.row(v);
    }
  }
  return forces;
}

void add_wrenches(const Points3& corner_forces, const Points3& corners, const Points3& centres,
                  Wrenches& wrenches) {
  for (int c = 0; c < corner_forces.rows(); ++c) {
    const int tile = c / 3;
    const Vec3 force = corner_forces.row(c), arm = corners.row(c) - centres.row(tile);
    wrenches.row(tile).head<3>() += force.transpose();
    wrenches.row(tile).tail<3>() += arm.cross(force).transpose();
  }
}

WrenchBalance wrench_balance(const Wrenches& wrenches, const Points3& centres, double lever) {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double mean = 0;
  if (wrenches.rows() == 0) return {0, 0};
  const Vec3 origin = centres.colwise().mean();
  for (int i = 0; i < wrenches.rows(); ++i) {
    const Vec3 f = wrenches.row(i).head<3>(), arm = centres.row(i).transpose() - origin;
    force += f;
    torque += wrenches.row(i).tail<3>().transpose() + arm.cross(f);
    mean += f.norm() / static_cast<double>(wrenches.rows());
  }
  if (!(mean > 0)) return {0, 0};
  return {force.cwiseAbs().maxCoeff() / mean, torque.cwiseAbs().maxCoeff() / (lever * mean)};
}

}  // namespace curveups
