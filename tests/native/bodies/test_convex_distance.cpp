// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {
namespace {

class Bodies {
 public:
  std::array<Vec2, 3> triangle() {
    for (;;) {
      std::array<Vec2, 3> t{Vec2(at(), at()), Vec2(at(), at()), Vec2(at(), at())};
      const double twice = wedge(t[1] - t[0], t[2] - t[0]);
      if (std::abs(twice) < 0.5) continue;
      if (twice < 0) std::swap(t[1], t[2]);
      return t;
    }
  }
  RigidMotion motion(double reach) {
    RigidMotion m;
    m.R = Eigen::Quaterniond(at(), at(), at(), at() + 0.1).normalized().toRotationMatrix();
    m.t = reach * Vec3(at(), at(), at());
    return m;
  }
  ConvexBody body(double reach) {
    return moved(make_prism(triangle(), 0, 0.5 + std::abs(at())), motion(reach));
  }
  double at() { return uniform_(random_); }

 private:
  std::mt19937 random_{42};
  std::uniform_real_distribution<double> uniform_{-2, 2};
};

const Vec3& support(const ConvexBody& body, const Vec3& d) {
  const Vec3* best = &body.points[0];
  for (const Vec3& p : body.points) {
    if (p.dot(d) > best->dot(d)) best = &p;
  }
  return *best;
}

// Bounds of the distance by Frank-Wolfe's method over the difference of both bodies, which shares
// nothing with the code under test: any supporting plane bounds from below, any point from above.
std::array<double, 2> distance_bounds(const ConvexBody& a, const ConvexBody& b) {
  Vec3 v = a.points[0] - b.points[0];
  double low = 0;
  for (int step = 0; step < 20000; ++step) {
    const Vec3 s = support(a, -v) - support(b, v);
    low = std::max(low, v.dot(s) / v.norm());
    if (v.norm() - low < 1e-7) break;
    const Vec3 d = s - v;
    if (d.squaredNorm() == 0) break;
    v += std::min(1.0, std::max(0.0, -v.dot(d) / d.squaredNorm())) * d;
    if (v.norm() < 1e-9) break;
  }
  return {low, v.norm()};
}

bool inside(const ConvexBody& body, const Vec3& p) {
  for (const BodyFace& face : body.faces) {
    if (face.plane.distance(p) > 1e-9) return false;
  }
  return true;
}

TEST(ConvexDistance, LiesWithinTheBoundsOfAnIndependentMethod) {
  Bodies make;
  int apart = 0, tight = 0;
  for (int run = 0; run < 300; ++run) {
    const ConvexBody a = make.body(1), b = make.body(run % 2 ? 3 : 1);
    const auto [low, high] = distance_bounds(a, b);
    const double d = distance(a, b);
    EXPECT_GE(d, low - 1e-9);
    EXPECT_LE(d, high + 1e-9);
    EXPECT_NEAR(distance(b, a), d, 1e-9);
    apart += d > 0.01;
    tight += high - low < 1e-3;
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(tight, 150);
}

TEST(ConvexDistance, NearestPointsMeetTheirVariationalInequality) {
  Bodies make;
  for (int run = 0; run < 300; ++run) {
    const ConvexBody body = make.body(1);
    const Vec3 p = 2 * Vec3(make.at(), make.at(), make.at());
    const Vec3 n = nearest_point(body, p);
    EXPECT_TRUE(inside(body, n));
    if (inside(body, p)) {
      EXPECT_EQ(n, p);
      continue;
    }
    for (const Vec3& v : body.points) EXPECT_LE((p - n).dot(v - n), 1e-9);
  }
}

TEST(ConvexDistance, CommonVolumeOfPrismsIsThatOfTheirOutlinesTimesTheirHeights) {
  Bodies make;
  int met = 0;
  for (int run = 0; run < 100; ++run) {
    const auto s = make.triangle(), t = make.triangle();
    const RigidMotion motion = make.motion(2);
    const double z[4] = {make.at(), 2.5, make.at(), 3.0};
    const ConvexBody a = moved(make_prism(s, z[0], z[1]), motion);
    const ConvexBody b = moved(make_prism(t, z[2], z[3]), motion);
    const Polygon common = intersection(Polygon(s.begin(), s.end()), Polygon(t.begin(), t.end()));
    const double expected = common.size() < 3 ? 0 : area(common) * (z[1] - std::max(z[0], z[2]));
    EXPECT_NEAR(common_volume(a, b), expected, 1e-9);
    met += expected > 0.01;
  }
  EXPECT_GT(met, 30);
}

std::vector<Vec3> sample(const CapSphere& cap, bool base) {
  const Vec3 u = cap.axis.unitOrthogonal(), v = cap.axis.cross(u);
  const double rim = std::acos(cap.flat / cap.radius);
  std::vector<Vec3> points;
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j < 90; ++j) {
      const double b = 2 * M_PI * j / 90;
      const Vec3 side = std::cos(b) * u + std::sin(b) * v;
      const double a = rim * i / 60, r = cap.radius * std::sin(rim) * i / 60;
      points.push_back(cap.centre +
                       (base ? Vec3(cap.flat * cap.axis + r * side)
                             : Vec3(cap.radius * (std::cos(a) * cap.axis + std::sin(a) * side))));
    }
  }
  return points;
}

double least(const std::vector<Vec3>& points, const ConvexBody& body) {
  double d = 1e300;
  for (const Vec3& p : points) d = std::min(d, (nearest_point(body, p) - p).norm());
  return d;
}

TEST(ConvexDistance, OfCapsIsThatOfTheirPointsOrTheBaseDiscIsNearer) {
  Bodies make;
  int on_cap = 0;
  for (int run = 0; run < 120; ++run) {
    const ConvexBody body = make.body(1);
    const RigidMotion motion = make.motion(3);
    const CapSphere cap = cap_sphere(motion.t, motion.R.col(2), 0.5, 0.25);
    EXPECT_NEAR(cap.radius, 0.625, 1e-12);
    const double caps = least(sample(cap, false), body), base = least(sample(cap, true), body);
    if (base < 1e-6) continue;  // the disc meets the body
    const double d = distance(cap, body);
    if (std::isinf(d)) {
      EXPECT_LE(base, caps + 1e-9);
    } else {
      EXPECT_NEAR(std::max(d, 0.0), caps, 5e-3);
      ++on_cap;
    }
  }
  EXPECT_GT(on_cap, 20);
}

TEST(ConvexDistance, OfTwoCapsThatFaceEachOtherIsExact) {
  const CapSphere a = cap_sphere({0, 0, 0}, {0, 0, 1}, 0.5, 0.25);
  const CapSphere b = cap_sphere({0.1, 0, 1}, {0, 0, -1}, 0.5, 0.25);
  EXPECT_NEAR(distance(a, b), std::hypot(0.1, 1 + 2 * a.flat) - 2 * a.radius, 1e-12);
  const CapSphere away = cap_sphere({0, 0, 1}, {0, 0, 1}, 0.5, 0.25);
  EXPECT_TRUE(std::isinf(distance(a, away)));
}

}  // namespace
}  // namespace curveups
