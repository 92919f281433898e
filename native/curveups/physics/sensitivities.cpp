// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/sensitivities.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Derivatives by the pin corners of one side.
struct CornerGradient {
  Points2 flat;
  Points3 actuated;
};

// z: virtual motions of the tiles (BalanceSystem::expand). Returns the derivatives of -z^T b.
std::vector<CornerGradient> corner_gradients(const SolvedMembrane& membrane, const Points3& centres,
                                             double lever, const std::vector<Array6>& motions) {
  const MembraneMesh& mesh = membrane.mesh;
  const Points3 &x = membrane.state.x, &force = membrane.state.gradient;
  std::vector<Points3> displacement(motions.size(), Points3::Zero(x.rows(), 3));
  for (std::size_t k = 0; k < motions.size(); ++k) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const int tile = mesh.pin[v];
      if (tile < 0) continue;
      const Vec3 shift = motions[k].row(tile).head<3>(),
                 turn = motions[k].row(tile).tail<3>() / lever,
                 arm = (x.row(v) - centres.row(tile)).transpose();
      displacement[k].row(v) = (shift + turn.cross(arm)).transpose();
    }
  }
  membrane.equilibrium->respond(x, displacement);
  std::vector<Points3> by_position;
  std::vector<Points2> by_flat;
  membrane.equilibrium->energy().second_derivatives(x, displacement, by_position, &by_flat);
  std::vector<CornerGradient> out;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    CornerGradient gradient{Points2::Zero(membrane.flat_corners.rows(), 2),
                            Points3::Zero(membrane.flat_corners.rows(), 3)};
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      Vec3 actuated = Vec3::Zero();
      if (mesh.pin[v] >= 0) {
        const Vec3 turn = motions[k].row(mesh.pin[v]).tail<3>() / lever, pull = force.row(v);
        // The arm about the tile's centre changes with the vertex.
        actuated = by_position[k].row(v).transpose() + pull.cross(turn);
      }
      for (int c = mesh.weights.start[v]; c < mesh.weights.start[v + 1]; ++c) {
        const double weight = mesh.weights.weight[c];
        gradient.flat.row(mesh.weights.corner[c]) += weight * by_flat[k].row(v);
        gradient.actuated.row(mesh.weights.corner[c]) += weight * actuated.transpose();
      }
    }
    out.push_back(std::move(gradient));
  }
  return out;
}

// Chain rule from pin corners to poses and insets.
void add_side(const DesignForces& forces, Side side, const CornerGradient& corner,
              ForceGradient& out) {
  const TileMesh& tiles = forces.geometry().tiles;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const PlaneRotation turn(forces.poses()(i, 2));
    const Vec2 origin = forces.poses().row(i).head<2>();
    const std::array<Vec2, 3>& face = tiles.corners(i, side);
    for (int t = 0; t < 3; ++t) {
      const int c = pin_corner_index(i, t);
      const Vec2 flat = corner.flat.row(c);
      const Vec2 arm = forces.membrane(side).flat_corners.row(c).transpose() - origin;
      out.by_pose.row(i) += Vec3(flat.x(), flat.y(), left_of(arm).dot(flat)).transpose();
      // Corner t moves along edge t by q[t - 1] and back along edge t - 1 by q[t] (inset_triangle).
      const Vec2 along = (face[next3(t)] - face[t]).normalized(),
                 back = (face[prev3(t)] - face[t]).normalized();
      const double sine = wedge(along, back);
      const Vec3 space = corner.actuated.row(c);
      const TileFrame& frame = tiles.frame[i];
      auto along_local = [&](const Vec2& d) {
        return (flat.dot(turn * d) + space.dot(d.x() * frame.x + d.y() * frame.y)) / sine;
      };
      out.by_inset(i, inset_index(side, prev3(t))) += along_local(along);
      out.by_inset(i, inset_index(side, t)) += along_local(back);
    }
  }
}

}  // namespace

std::vector<ForceGradient> force_gradients(const DesignForces& forces,
                                           const Eigen::MatrixXd& functions) {
  const BalanceSystem& system = forces.system();
  const int count = static_cast<int>(functions.cols()), points = system.point_count();
  const int tiles = forces.geometry().tiles.tile_count();
  Eigen::MatrixXd right(system.rows(), count);
  for (int k = 0; k < count; ++k) {
    Eigen::VectorXd normal = Eigen::VectorXd::Zero(3 * points);
    for (int p = 0; p < points; ++p) normal(3 * p) = functions(p, k);
    right.col(k) = system.apply(normal);
  }
  const Eigen::MatrixXd z = system.solve(right);
  std::vector<ForceGradient> out(count, {Array3::Zero(tiles, 3), Array6::Zero(tiles, 6)});
  // Displacement fields of this many functions fit into some hundred MB at 300,000 triangles.
  constexpr int batch = 16;
  for (int first = 0; first < count; first += batch) {
    std::vector<Array6> motions;
    for (int k = first; k < std::min(count, first + batch); ++k) {
      motions.push_back(system.expand(z.col(k)));
    }
    std::array<std::vector<CornerGradient>, 2> corners;
    auto solve = [&](Side side) {
      corners[static_cast<int>(side)] =
          corner_gradients(forces.membrane(side), system.centres(), system.lever(), motions);
    };
    parallel_pair([&] { solve(Side::front); }, [&] { solve(Side::back); });
    for (std::size_t k = 0; k < motions.size(); ++k) {
      for (Side side : {Side::front, Side::back}) {
        add_side(forces, side, corners[static_cast<int>(side)][k], out[first + k]);
      }
    }
  }
  return out;
}

}  // namespace curveups
