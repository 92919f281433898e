// SPDX-License-Identifier: LGPL-2.1-or-later
// Convex blocks with friction, for answers that statics knows.
#pragma once

#include <gtest/gtest.h>

#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/given_forces.hpp"

namespace curveups::test {

inline constexpr double stone_stiffness = 100;  // N / mm3

// A prism between y = -depth / 2 and depth / 2 over a convex outline in x and z, counter-clockwise
// seen from -y (x to the right, z up).
inline ConvexBody prism(const std::vector<Vec2>& outline, double depth) {
  ConvexBody body;
  const int n = static_cast<int>(outline.size());
  for (double y : {-depth / 2, depth / 2}) {
    for (const Vec2& p : outline) body.points.push_back({p.x(), y, p.y()});
  }
  auto face = [&](std::vector<int> loop) {
    const Vec3 a = body.points[loop[0]], b = body.points[loop[1]], c = body.points[loop[2]];
    const Vec3 normal = (b - a).cross(c - b).normalized();
    body.faces.push_back(
        {std::move(loop), static_cast<int>(body.faces.size()), {normal, normal.dot(a)}});
  };
  std::vector<int> front, back;
  for (int k = 0; k < n; ++k) {
    front.push_back(k);
    back.insert(back.begin(), n + k);
  }
  face(front);
  face(back);
  for (int k = 0; k < n; ++k) face({k, n + k, n + (k + 1) % n, (k + 1) % n});
  // Loops are counter-clockwise seen from outside: front from -y.
  return body;
}

inline ConvexBody box(double width, double depth, double height, const Vec2& middle) {
  const double x = width / 2, z = height / 2;
  return prism({{middle.x() - x, middle.y() - z},
                {middle.x() + x, middle.y() - z},
                {middle.x() + x, middle.y() + z},
                {middle.x() - x, middle.y() + z}},
               depth);
}

// Bodies that are put where they are drawn, with their weights.
struct Scene {
  std::vector<RigidBody> bodies;
  Poses poses;
  std::vector<PointLoad> loads;
  WorldOptions options;

  int add(const ConvexBody& shape, bool fixed) {
    const Vec3 middle = centroid(shape);
    bodies.push_back(make_rigid_body(shape, middle, stone_stiffness));
    bodies.back().fixed = fixed;
    poses.push_back({Eigen::Matrix3d::Identity(), middle});
    return static_cast<int>(bodies.size()) - 1;
  }
  void load(int body, const Vec3& force) { loads.push_back({body, Vec3::Zero(), force}); }
  std::unique_ptr<ContactWorld> world(double friction) const {
    auto out = std::make_unique<ContactWorld>(bodies, poses, options);
    out->add(std::make_unique<PointLoads>(loads));
    out->set_friction(friction);
    return out;
  }
};

}  // namespace curveups::test
