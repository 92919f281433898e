// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/tile_world.hpp"

namespace curveups {
namespace {

double size_of_forces(const ReducedMembrane& membrane, const Poses& poses) {
  Motions forces = Motions::Zero(poses.size(), 6);
  membrane.derivatives(poses, 1, forces, nullptr, 0);
  return forces.leftCols<3>().norm();
}

// Pin corners with one half of the layout moved: that which lies further along the longer side of
// the layout's box. layout: corners of front pins, which say where a tile is.
Points2 with_half_moved(Points2 corners, const Points2& layout, const Conditions& conditions) {
  const Eigen::RowVector2d low = layout.colwise().minCoeff(), high = layout.colwise().maxCoeff();
  const Eigen::RowVector2d middle = 0.5 * (low + high);
  const int axis = high(0) - low(0) >= high(1) - low(1) ? 0 : 1;
  const PlaneRotation turn(conditions.half_turn * EIGEN_PI / 180);
  for (Eigen::Index c = 0; c < corners.rows(); c += 3) {
    if (!(layout.middleRows<3>(c).col(axis).mean() > middle(axis))) continue;
    for (Eigen::Index k = c; k < c + 3; ++k) {
      const Vec2 arm = (corners.row(k) - middle).transpose();
      corners.row(k) = middle + (turn * arm).transpose();
      corners(k, axis) += conditions.half_shift;
    }
  }
  return corners;
}

// A wall with all that stands on it, grown along its normal: by `growth`, and by `taper` more at
// the front face than at the back, which lies H_body behind it. front: the front's normal.
void grow(BodySurface& wall, double growth, double taper, const Vec3& front, double H_body) {
  const double slope = taper / H_body, lean = slope * front.dot(wall.normal);
  auto moved = [&](const Vec3& p) -> Vec3 {
    const double by = growth + 0.5 * taper + slope * front.dot(p);
    return p + by / (1 - lean) * wall.normal;
  };
  for (Vec3& corner : wall.outline) corner = moved(corner);
  for (Vec3& tip : wall.tips) tip = moved(tip);
  const Vec3 normal = wall.normal - slope * front;
  wall.offset = (wall.offset + growth + 0.5 * taper) / normal.norm();
  wall.normal = normal.normalized();
}

}  // namespace

bool Conditions::operator==(const Conditions& other) const {
  return pull == other.pull && stretch == other.stretch && growth == other.growth &&
         taper == other.taper && half_shift == other.half_shift && half_turn == other.half_turn;
}

void TileWorld::set(const Conditions& next) {
  const bool moved =
      next.half_shift != conditions.half_shift || next.half_turn != conditions.half_turn;
  const bool grown = next.growth != conditions.growth || next.taper != conditions.taper;
  conditions = next;
  for (int s = 0; s < 2; ++s) {
    ReducedMembrane& membrane = *membranes[s];
    membrane.pull = 1;
    membrane.stretch.setOnes();
    if (moved) membrane.set_flat(designed.flat_corners[s]);
    const double before = size_of_forces(membrane, designed.start);
    membrane.pull = next.pull[s];
    membrane.stretch = next.stretch;
    // What the finite elements pull besides changes as the reduced membrane's forces do.
    const double factor = before > 0 ? size_of_forces(membrane, designed.start) / before : 1;
    corrections[s]->loads = designed.corrections[s];
    for (PairLoad& load : corrections[s]->loads) load.force *= factor;
    if (next.half_shift != 0 || next.half_turn != 0) {
      membrane.set_flat(with_half_moved(designed.flat_corners[s], designed.flat_corners[0], next));
    }
  }
  world->energies_changed();
  if (!grown) return;
  std::vector<RigidBody> bodies = designed.bodies;
  for (int i = 0; i < tile_count; ++i) {
    for (std::size_t f = 0; f < bodies[i].faces.size(); ++f) {
      if (!designed.is_wall[i][f]) continue;
      grow(bodies[i].faces[f], next.growth, next.taper, designed.normals.row(i), designed.H_body);
    }
  }
  world->set_bodies(std::move(bodies));
}

}  // namespace curveups
