// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/rigid_body.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Motion in unit time of a point with this velocity, which turns with the point (R. M. Murray, Z.
// Li, S. S. Sastry, A Mathematical Introduction to Robotic Manipulation, 1994, eq. 2.36).
Vec3 screw_shift(const Vec3& velocity, const Vec3& turn) {
  const double a = turn.norm(), half = std::sin(0.5 * a);
  const double one = a < 1e-4 ? 0.5 : 2 * half * half / (a * a);
  const double two = a < 1e-4 ? 1.0 / 6 : (a - std::sin(a)) / (a * a * a);
  const Vec3 across = turn.cross(velocity);
  return velocity + one * across + two * turn.cross(across);
}

}  // namespace

double largest_motion(const Motions& rows) {
  return std::sqrt(std::max(rows.leftCols<3>().rowwise().squaredNorm().maxCoeff(),
                            rows.rightCols<3>().rowwise().squaredNorm().maxCoeff()));
}

Poses moved(const Poses& poses, const Motions& motions, double lever) {
  Poses out = poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 turn = motions.row(i).tail<3>() / lever;
    out[i].t += screw_shift(motions.row(i).head<3>(), turn);
    const double angle = turn.norm();
    if (angle == 0) continue;
    // A quaternion keeps rounding from shearing a body over many steps.
    Eigen::Quaterniond q =
        Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * Eigen::Quaterniond(poses[i].R);
    out[i].R = q.normalized().toRotationMatrix();
  }
  return out;
}

Vec3 twice_axial_vector(const Eigen::Matrix3d& M) {
  return {M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1)};
}

Motions motions_between(const Poses& from, const Poses& to, double lever) {
  Motions out(from.size(), 6);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::Matrix3d turn = to[i].R * from[i].R.transpose();
    const Vec3 axis = twice_axial_vector(turn);
    const double sine = 0.5 * axis.norm(), angle = std::atan2(sine, 0.5 * (turn.trace() - 1));
    const double factor = sine > 1e-9 ? angle / (2 * sine) : 0.5;
    out.row(i) << (to[i].t - from[i].t).transpose(), lever * factor * axis.transpose();
  }
  return out;
}

Eigen::Matrix3d skew(const Vec3& v) {
  Eigen::Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

RigidBody make_rigid_body(const ConvexBody& shape, const Vec3& origin, double stiffness) {
  RigidBody body;
  for (const BodyFace& face : shape.faces) {
    BodySurface surface{face.plane.normal, face.plane.distance(origin), {}, {}, stiffness, 0};
    surface.offset = -surface.offset;
    for (int point : face.loop) surface.outline.push_back(shape.points[point] - origin);
    body.faces.push_back(std::move(surface));
  }
  return body;
}

}  // namespace curveups
