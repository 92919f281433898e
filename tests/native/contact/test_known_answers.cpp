// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "contact/blocks.hpp"

namespace curveups::test {
namespace {

constexpr double pi = 3.14159265358979323846;

// A block of 10 mm and 1 N on a slope of this angle, 2 mm high: it slips before it tips.
Scene slope(double angle, double gap = 0) {
  Scene scene;
  auto turned = [&](const ConvexBody& shape) {
    ConvexBody out = shape;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    for (Vec3& p : out.points) p = R * p;
    for (BodyFace& face : out.faces) {
      face.plane.normal = R * face.plane.normal;
      face.plane.offset = face.plane.normal.dot(out.points[face.loop[0]]);
    }
    return out;
  };
  scene.add(turned(box(200, 40, 10, {0, -5})), true);
  scene.add(turned(box(10, 10, 2, {0, 1 + gap})), false);
  scene.load(1, {0, 0, -1});
  return scene;
}

TEST(KnownAnswers, BlockOnASlopeSlipsWhereFrictionIsTheTangentOfItsAngle) {
  const double angle = 0.5, limit = std::tan(angle);
  for (double side : {1.0, -1.0}) {
    auto world = slope(angle).world(limit * (1 + side * 1e-3));
    const Vec3 start = world->poses()[1].t;
    const StepReport report = world->settle(40);
    const double moved = (world->poses()[1].t - start).norm();
    if (side > 0) {
      EXPECT_TRUE(report.at_rest);
      EXPECT_LT(moved, 1e-3);
    } else {
      EXPECT_FALSE(report.at_rest);
      EXPECT_GT(moved, 10);
    }
  }
}

TEST(KnownAnswers, BlockUnderChangingLoadsDoesNotCreep) {
  const double angle = 0.5;
  Scene scene = slope(angle);
  auto world = scene.world(std::tan(angle) * 1.02);
  auto sideways =
      std::make_unique<PointLoads>(std::vector<PointLoad>{{1, Vec3::Zero(), Vec3::Zero()}});
  PointLoads* shaking = sideways.get();
  world->add(std::move(sideways));
  const Vec3 down(std::cos(angle), 0, -std::sin(angle));
  auto after_cycles = [&](int count) {
    for (int k = 0; k < count; ++k) {
      for (double sign : {1.0, -1.0, 0.0}) {
        shaking->loads[0].force = sign * 0.005 * down;  // 1 % of what pulls it down
        EXPECT_TRUE(world->settle(40).at_rest);
      }
    }
    return world->poses()[1].t;
  };
  const Vec3 once = after_cycles(2);
  EXPECT_LT((after_cycles(100) - once).norm(), 1e-8);
}

TEST(KnownAnswers, NothingSlipsFurtherThanItMoves) {
  Scene scene;
  scene.add(box(10, 10, 10, {0, 0}), true);
  scene.add(box(10, 10, 10, {0, 9.99}), false);
  ContactEnergy energy;
  energy.friction_coefficient = 0.1;
  energy.pairs = find_touching(scene.bodies, scene.poses, {}, {});
  ASSERT_EQ(energy.pairs.size(), 1u);
  // More than these points can hold, inherited from some that were softer.
  for (Touch& touch : energy.pairs[0].touches) touch.stretch = {170, 0};
  energy.lag_friction(scene.poses);
  energy.remember(scene.poses);
  for (const TouchForce& force : energy.forces(scene.poses)) {
    EXPECT_GT(force.push, 0);
    EXPECT_EQ(force.slip, 0);
  }
  scene.poses[1].t.x() += 0.5;
  energy.lag_friction(scene.poses);
  energy.remember(scene.poses);
  for (const TouchForce& force : energy.forces(scene.poses)) {
    EXPECT_LE(force.slip, 0.5 + 1e-12);
    EXPECT_GT(force.slip, 0.49);  // but for what springs give way by
  }
}

TEST(KnownAnswers, BlockCrossesAClearanceWithoutSticking) {
  // Onto a slope that it would slide on, and onto one that it would not.
  const double angle = 0.3;
  for (double mu : {0.8, 0.2}) {
    auto world = slope(angle, 0.1).world(mu);
    const Vec3 start = world->poses()[1].t;
    const StepReport report = world->settle(60);
    const Vec3 moved = world->poses()[1].t - start;
    const Vec3 normal(std::sin(angle), 0, std::cos(angle));
    EXPECT_NEAR(normal.dot(moved), -0.1, 1e-3) << mu;
    EXPECT_EQ(report.at_rest, mu > std::tan(angle)) << mu;
  }
}

TEST(KnownAnswers, BlocksOfTwoPiecesDoNotTouch) {
  // Side by side, a tenth of a millimetre into one another: they push only within one piece.
  for (int piece : {0, 1}) {
    Scene scene;
    scene.add(box(10, 10, 10, {0, 0}), false);
    scene.add(box(10, 10, 10, {9.9, 0}), false);
    scene.bodies[0].piece = 0;
    scene.bodies[1].piece = piece;
    auto world = scene.world(0.5);
    world->settle(30);
    const double apart = (world->poses()[1].t - world->poses()[0].t).norm();
    EXPECT_NEAR(apart, piece == 0 ? 10 : 9.9, 1e-3) << piece;
  }
}

// A block of 1 N between two walls that stand `gap` away from it on either side, or press into it.
Scene between_walls(double gap) {
  Scene scene;
  scene.add(box(10, 40, 400, {-10 - gap, 0}), true);
  scene.add(box(10, 40, 400, {10 + gap, 0}), true);
  scene.add(box(10, 10, 10, {0, 0}), false);
  scene.load(2, {0, 0, -1});
  return scene;
}

TEST(KnownAnswers, BlockBetweenTwoWallsFallsWithoutClamping) {
  for (double gap : {0.0, 0.1}) {
    auto world = between_walls(gap).world(1.0);
    const StepReport report = world->settle(30);
    EXPECT_FALSE(report.at_rest) << gap;
    EXPECT_LT(world->poses()[2].t.z(), -10) << gap;
  }
}

TEST(KnownAnswers, ClampedBlockCarriesTwiceItsFriction) {
  // The clamping force follows from how far the walls press into it.
  const double gap = -1e-2;
  Scene scene = between_walls(gap);
  scene.loads[0].force = {0, 0, -1e-6};
  auto world = scene.world(0.5);
  ASSERT_TRUE(world->settle(40).at_rest);
  double clamping = 0;
  for (const TouchForce& force : world->forces()) {
    if (force.body[0] == 0) clamping += force.push;
  }
  EXPECT_NEAR(clamping, 0.5 * stone_stiffness * 100 * 1e-2, 1);
  for (double side : {0.999, 1.001}) {
    scene.loads[0].force = {0, 0, -2 * 0.5 * clamping * side};
    auto loaded = scene.world(0.5);
    EXPECT_EQ(loaded->settle(40).at_rest, side < 1) << side;
  }
}

// A wedge of this half angle, pressed into the groove between two walls and let go.
double push_left_in_groove(double half_angle, double friction) {
  Scene scene;
  const double s = std::tan(half_angle);
  auto wall = [&](double side) {
    std::vector<Vec2> outline = {{0, -40}, {40 + 40 * s, -40}, {40 + 40 * s, 40}, {80 * s, 40}};
    if (side < 0) {
      for (Vec2& p : outline) p.x() = -p.x();
      std::reverse(outline.begin(), outline.end());
    }
    return prism(outline, 20);
  };
  scene.add(wall(1), true);
  scene.add(wall(-1), true);
  scene.add(prism({{-30 * s, -10}, {30 * s, -10}, {50 * s, 10}, {-50 * s, 10}}, 10), false);
  auto world = scene.world(friction);
  auto force =
      std::make_unique<PointLoads>(std::vector<PointLoad>{{2, Vec3::Zero(), {0, 0, -100}}});
  PointLoads* pressing = force.get();
  world->add(std::move(force));
  EXPECT_TRUE(world->settle(60).at_rest);
  double pressed = 0, left = 0;
  for (const TouchForce& touch : world->forces()) pressed += touch.push;
  EXPECT_GT(pressed, 50);
  // Hold back a little so that a wedge that is free has somewhere to go.
  pressing->loads[0].force = {0, 0, 1e-3};
  world->settle(60);
  for (const TouchForce& touch : world->forces()) left += touch.push;
  return left / pressed;
}

TEST(KnownAnswers, WedgeHoldsWhereTheTangentOfItsHalfAngleIsBelowFriction) {
  const double half_angle = 0.2, limit = std::tan(half_angle);
  EXPECT_GT(push_left_in_groove(half_angle, 1.05 * limit), 0.3);
  EXPECT_LT(push_left_in_groove(half_angle, 0.95 * limit), 1e-3);
}

// True if a tower of stones stands, the k-th from the top over the next by `share` / (2 k) of its
// length.
bool tower_stands(int stones, double share) {
  Scene scene;
  const double length = 100, height = 10;
  double x = 0;
  for (int k = 1; k <= stones; ++k) {
    const int body = scene.add(box(length, 50, height, {x, -height * k}), false);
    scene.load(body, {0, 0, -1});
    x -= share * length / (2 * k);
  }
  scene.add(box(length, 50, height, {x, -height * (stones + 1)}), true);
  scene.options.pace.step_limit = 2;
  auto world = scene.world(0.7);
  const Vec3 start = world->poses()[0].t;
  const auto falls = [&] { return (world->poses()[0].t - start).norm() > 5; };
  const bool at_rest = world->settle(100, [&](const StepReport&) { return falls(); }).at_rest;
  EXPECT_NE(at_rest, falls());
  return at_rest;
}

TEST(KnownAnswers, TowerStandsJustBelowTheHarmonicOverhang) {
  EXPECT_TRUE(tower_stands(20, 0.99));
  EXPECT_FALSE(tower_stands(20, 1.01));
}

}  // namespace
}  // namespace curveups::test
