// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/flat_piece.hpp"

#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/physics/membrane_domain.hpp"

namespace curveups {

Poses flat_tiles(const TileBodies& bodies) {
  const TileMesh& tiles = bodies.geometry.tiles;
  const Points3 centres = tile_centres(tiles);
  Poses out;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const RigidMotion flat = flat_motion(bodies.poses, i, 0);
    const RigidMotion& actuated = tiles.frame[i];
    const Eigen::Matrix3d R = flat.R * actuated.R.transpose();
    out.push_back({R, flat.t + R * (centres.row(i).transpose() - actuated.t)});
  }
  return out;
}

FrameRows frame_rows(const TileMesh& tiles, const Poses& poses) {
  const Points3 centres = tile_centres(tiles);
  FrameRows rows(tiles.tile_count(), 7);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    Eigen::Quaterniond turn(poses[i].R);
    if (turn.w() < 0) turn.coeffs() *= -1;
    const Vec3 shift = poses[i].t - poses[i].R * centres.row(i).transpose();
    rows.row(i) << shift.transpose(), turn.w(), turn.vec().transpose();
  }
  return rows;
}

std::vector<RigidMotion> frame_motions(const FrameRows& rows, int tile_count) {
  if (rows.rows() != tile_count) {
    throw InvalidInput("the frame has poses of " + std::to_string(rows.rows()) +
                           " tiles, the design has " + std::to_string(tile_count),
                       "give a frame of this design");
  }
  std::vector<RigidMotion> out;
  for (int i = 0; i < tile_count; ++i) {
    const Eigen::Quaterniond turn(rows(i, 3), rows(i, 4), rows(i, 5), rows(i, 6));
    if (!rows.row(i).allFinite() || !(std::abs(turn.norm() - 1) < 1e-3) ||
        rows.row(i).head<3>().cwiseAbs().maxCoeff() > 1e8) {
      throw InvalidInput("the frame's pose of " + tile_name(i) + " is no rigid motion",
                         "give x, y, z in mm and a unit quaternion w, x, y, z", {i});
    }
    out.push_back({turn.normalized().toRotationMatrix(), rows.row(i).head<3>().transpose()});
  }
  return out;
}

Poses piece_poses(const TileWorld& piece, const Poses& tiles) {
  Poses out = tiles;
  for (Side side : {Side::front, Side::back}) {
    const Poses nodes =
        membrane_nodes(piece.domain[static_cast<int>(side)], piece.pin_corners(side, tiles));
    out.insert(out.end(), nodes.begin(), nodes.end());
  }
  return out;
}

double mean_stretch(const TileWorld& piece, const TileBodies& bodies) {
  double sum = 0;
  int count = 0;
  for (Side side : {Side::front, Side::back}) {
    const Points3 now = piece.pin_corners(side, piece.world->poses());
    const Points2 flat = flat_pin_corners(bodies.geometry.tiles, bodies.poses, bodies.q, side);
    for (const MembranePatch& patch : piece.domain[static_cast<int>(side)].patches) {
      if (patch.contact < 0) continue;
      const std::vector<int>& c = patch.corners;
      auto bridge = [&](const auto& at) {
        return (at.row(c[0]) + at.row(c[1]) - at.row(c[2]) - at.row(c[3])).norm();
      };
      sum += bodies.parameters.tau * bridge(now) / bridge(flat);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace curveups
