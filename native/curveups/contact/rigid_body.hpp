// SPDX-License-Identifier: LGPL-2.1-or-later
// Convex rigid bodies, where they are, and small motions of them.
#pragma once

#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/numerics/term.hpp"

namespace curveups {

// A planar face by which a body touches others, in the body's own coordinates.
struct BodySurface {
  Vec3 normal;                // unit, outward
  double offset;              // the face lies where normal . x = offset
  std::vector<Vec3> outline;  // counter-clockwise seen from outside
  // What stands on the face and touches in its place, such as the apexes of bumps. Empty: the face
  // touches with its own plane.
  std::vector<Vec3> tips = {};
  double stiffness = 0;      // of the body below the face, N / mm3: a pressure a depth
  double tip_stiffness = 0;  // of one tip, N / mm
};

// Coordinates are about a point of the body near its middle. A body without faces is a point that
// moves freely, such as a vertex of a membrane. Bodies of two pieces do not touch.
struct RigidBody {
  std::vector<BodySurface> faces;
  bool fixed = false;
  int piece = every_piece;

  bool is_point() const { return faces.empty(); }

  static constexpr int every_piece = -1;  // of what touches all
  bool can_touch(const RigidBody& other) const {
    return !(fixed && other.fixed) &&
           (piece == other.piece || piece == every_piece || other.piece == every_piece);
  }
};

// Where each body is.
using Poses = std::vector<RigidMotion>;

// Small motions, a row a body: how far its origin moves (mm), and by how much it turns, a rotation
// vector in world coordinates times `lever`, so that all six are lengths.
using Motions = BlockVector<6>;

// Of a row's two parts the longer one; of all rows the longest. Forces have rows of this kind, too.
double size_of_motion(const Motions& rows, int i);
double largest_motion(const Motions& rows);

// The poses after these motions, along screws: bodies that turn as one about whatever axis stay as
// they are to one another. Rows of zeros leave a pose as it is, bit by bit.
Poses moved(const Poses& poses, const Motions& motions, double lever);
// The motions that lead from one to the other, where origins go straight and turns are less than
// half a circle.
Motions motions_between(const Poses& from, const Poses& to, double lever);
// Twice the axial vector of M's antisymmetric part; of a rotation, the axis times twice the sine.
Vec3 twice_axial_vector(const Eigen::Matrix3d& M);

// The skew-symmetric matrix S of v: S x = v x x.
Eigen::Matrix3d skew(const Vec3& v);

// A body with the faces of a convex polyhedron, about `origin`. stiffness: as BodySurface has it.
RigidBody make_rigid_body(const ConvexBody& shape, const Vec3& origin, double stiffness);

}  // namespace curveups
