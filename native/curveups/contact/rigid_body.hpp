// SPDX-License-Identifier: LGPL-2.1-or-later
// Convex rigid bodies, their poses, and small motions.
#pragma once

#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/numerics/block_matrix.hpp"

namespace curveups {

// A planar face by which a body touches others, in the body's own coordinates.
struct BodySurface {
  Vec3 normal;                // unit, outward
  double offset;              // the face lies where normal . x = offset
  std::vector<Vec3> outline;  // counter-clockwise seen from outside
  // Points that stand on the face and touch in its place, such as apexes of bumps; empty: the face
  // touches with its own plane.
  std::vector<Vec3> tips = {};
  double stiffness = 0;      // pressure per depth of the body below the face, N / mm3
  double tip_stiffness = 0;  // N / mm
};

// Coordinates are about a point of the body near its middle. A body without faces is a point that
// moves freely, such as a vertex of a membrane. Bodies of two pieces do not touch.
struct RigidBody {
  std::vector<BodySurface> faces;
  bool fixed = false;
  int piece = every_piece;

  bool is_point() const { return faces.empty(); }

  static constexpr int every_piece = -1;  // touches all pieces
  bool can_touch(const RigidBody& other) const {
    return !(fixed && other.fixed) &&
           (piece == other.piece || piece == every_piece || other.piece == every_piece);
  }
};

// Pose of each body.
using Poses = std::vector<RigidMotion>;

// Small motions, a row a body: motion of its origin (mm), and rotation vector in world coordinates
// times `lever`, so that all six are lengths.
using Motions = BlockVector<6>;

// Largest norm of a row's two halves, over all rows; forces have rows of this kind, too.
double largest_motion(const Motions& rows);

// Poses after these motions, along screws: bodies that turn as one about any axis keep their
// relative poses. Rows of zeros leave a pose bit for bit.
Poses moved(const Poses& poses, const Motions& motions, double lever);
// Motions that lead from one to the other, where origins go straight and turns are less than half a
// circle.
Motions motions_between(const Poses& from, const Poses& to, double lever);
// Twice the axial vector of M's antisymmetric part; for a rotation, the axis times twice the sine.
Vec3 twice_axial_vector(const Eigen::Matrix3d& M);

// The skew-symmetric matrix S of v: S x = v x x.
Eigen::Matrix3d skew(const Vec3& v);

// A body with the faces of a convex polyhedron, about `origin`. stiffness: as BodySurface has it.
RigidBody make_rigid_body(const ConvexBody& shape, const Vec3& origin, double stiffness);

}  // namespace curveups
