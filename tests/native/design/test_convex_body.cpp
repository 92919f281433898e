// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "curveups/design/convex_body.hpp"

namespace curveups {
namespace {

ConvexBody sample() {
  const std::array<Vec2, 3> top = {Vec2(0, 0), Vec2(7, 0), Vec2(3, 6)};
  const std::array<Vec2, 3> bottom = {Vec2(1, 0.5), Vec2(5.5, 0.5),
                                      Vec2(1 + 4.5 * 3 / 7.0, 0.5 + 4.5 * 6 / 7.0)};
  return make_frustum(top, 0, bottom, -3);
}

// Every edge runs once each way: a closed surface.
void expect_closed(const ConvexBody& body) {
  std::map<std::pair<int, int>, int> edges;
  for (const BodyFace& face : body.faces) {
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      ++edges[{face.loop[k], face.loop[(k + 1) % face.loop.size()]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

TEST(ConvexBody, FrustumVolumeIsThePrismatoidFormula) {
  const ConvexBody body = sample();
  const double a = 21, b = a * (4.5 / 7) * (4.5 / 7);
  EXPECT_NEAR(volume(body), 3.0 / 3 * (a + b + std::sqrt(a * b)), 1e-12);
  expect_closed(body);
}

TEST(ConvexBody, BothHalvesOfACutMakeTheWhole) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int k = 0; k < 500; ++k) {
    Vec3 normal(uniform(random), uniform(random), uniform(random));
    normal.normalize();
    const Vec3 through(2 + 3 * uniform(random), 2 + 2 * uniform(random),
                       -1.5 + 1.5 * uniform(random));
    ConvexBody near = sample(), far = sample();
    clip(near, {normal, normal.dot(through)}, body_tag::cut);
    clip(far, {-normal, -normal.dot(through)}, body_tag::cut);
    double sum = 0;
    for (const ConvexBody* half : {&near, &far}) {
      if (half->faces.empty()) continue;
      expect_closed(*half);
      sum += volume(*half);
    }
    EXPECT_NEAR(sum, volume(sample()), 2e-4);  // corners within a snap of the plane count twice
    if (!near.faces.empty()) {
      for (const Vec3& p : near.points) EXPECT_LE(normal.dot(p - through), 1.1e-5);
    }
  }
}

TEST(ConvexBody, PlaneOfAWallCutsNothing) {
  ConvexBody body = sample();
  const std::size_t faces = body.faces.size();
  EXPECT_FALSE(clip(body, body.faces[2].plane, body_tag::cut));
  EXPECT_EQ(body.faces.size(), faces);
}

TEST(ConvexBody, PlaneThroughAnEdgeMakesNoSliver) {
  ConvexBody body = sample();
  // Through two top corners, tilted inwards: the cut face is a triangle or quadrilateral with them.
  const Vec3 a = body.points[0], b = body.points[1];
  const Vec3 normal = (b - a).cross(Vec3(0.1, -1, -0.8).normalized()).normalized();
  clip(body, {normal, normal.dot(a)}, body_tag::cut);
  expect_closed(body);
  for (const BodyFace& face : body.faces) {
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      const Vec3 d = body.points[face.loop[k]] - body.points[face.loop[(k + 1) % face.loop.size()]];
      EXPECT_GT(d.norm(), 1e-5);
    }
  }
}

TEST(ConvexBody, WhatLiesBeyondThePlaneVanishes) {
  ConvexBody body = sample();
  EXPECT_TRUE(clip(body, {Vec3::UnitZ(), -10}, body_tag::cut));
  EXPECT_TRUE(body.faces.empty());
}

TEST(ConvexBody, CentroidOfAPrismIsItsMiddle) {
  const std::array<Vec2, 3> t = {Vec2(0, 0), Vec2(6, 0), Vec2(0, 3)};
  EXPECT_LT((centroid(make_frustum(t, 2, t, -2)) - Vec3(2, 1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace curveups
