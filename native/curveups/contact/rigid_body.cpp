// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/rigid_body.hpp"

#include "curveups/core/parallel.hpp"

namespace curveups {

namespace {

// How far a point moves that starts with this velocity and turns with it (R. M. Murray, Z. Li, S.
// S. Sastry, A Mathematical Introduction to Robotic Manipulation, 1994, eq. 2.36).
Vec3 screw_shift(const Vec3& velocity, const Vec3& turn) {
  const double a = turn.norm();
  const double one = a < 1e-4 ? 0.5 : (1 - std::cos(a)) / (a * a);
  const double two = a < 1e-4 ? 1.0 / 6 : (a - std::sin(a)) / (a * a * a);
  const Vec3 across = turn.cross(velocity);
  return velocity + one * across + two * turn.cross(across);
}

// The inverse: the velocity.
Vec3 screw_velocity(const Vec3& shift, const Vec3& turn) {
  const double a = turn.norm();
  const double two =
      a < 1e-4 ? 1.0 / 12 : (1 - 0.5 * a * std::sin(a) / (1 - std::cos(a))) / (a * a);
  const Vec3 across = turn.cross(shift);
  return shift - 0.5 * across + two * turn.cross(across);
}

}  // namespace

Poses moved(const Poses& poses, const Motions& motions, double lever) {
  Poses out = poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 turn = motions.row(i).tail<3>() / lever;
    out[i].t += screw_shift(motions.row(i).head<3>(), turn);
    const double angle = turn.norm();
    if (angle == 0) continue;
    // By a quaternion: rounding must not shear a body over many steps.
    Eigen::Quaterniond q =
        Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * Eigen::Quaterniond(poses[i].R);
    out[i].R = q.normalized().toRotationMatrix();
  }
  return out;
}

Motions motions_between(const Poses& from, const Poses& to, double lever) {
  Motions out(from.size(), 6);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::Matrix3d R = to[i].R * from[i].R.transpose();
    const Vec3 axial(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
    const double sine = 0.5 * axial.norm(), angle = std::atan2(sine, 0.5 * (R.trace() - 1));
    const Vec3 turn = (sine > 1e-9 ? angle / (2 * sine) : 0.5) * axial;
    out.row(i).head<3>() = screw_velocity(to[i].t - from[i].t, turn).transpose();
    out.row(i).tail<3>() = lever * turn.transpose();
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
