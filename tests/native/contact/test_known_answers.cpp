// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <limits>

#include "contact/blocks.hpp"
#include "curveups/contact/reduced_membrane.hpp"
#include "curveups/geometry/planar_mesh.hpp"

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
    EXPECT_TRUE(report.converged);
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

TEST(KnownAnswers, UnlimitedFrictionHoldsWhateverTouches) {
  // On a slope of 75 degrees no coefficient below 3.7 does. A block above the slope falls past it.
  for (const double gap : {0.0, 5.0}) {
    Scene scene = slope(75 * pi / 180, gap);
    scene.loads.front().force *= 0.01;  // barely pushes
    auto world = scene.world(std::numeric_limits<double>::infinity());
    const Vec3 start = world->poses()[1].t;
    const StepReport report = world->settle(40);
    const double moved = (world->poses()[1].t - start).norm();
    EXPECT_EQ(report.at_rest, gap == 0);
    if (gap == 0) {
      EXPECT_LT(moved, 1e-3);
    } else {
      EXPECT_GT(moved, 10);
    }
  }
}

TEST(KnownAnswers, BlockOnASlopeDoesNotCreep) {
  const double angle = 0.5;
  auto world = slope(angle).world(std::tan(angle) * 1.001);
  ASSERT_TRUE(world->settle(40).at_rest);
  const RigidMotion before = world->poses()[1];
  for (int k = 0; k < 1000000; ++k) ASSERT_TRUE(world->step().at_rest);
  EXPECT_EQ(world->poses()[1].t, before.t);
  EXPECT_EQ(world->poses()[1].R, before.R);
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
  energy.remember(scene.poses);
  for (const TouchForce& force : energy.forces(scene.poses)) {
    EXPECT_GT(force.push, 0);
    EXPECT_EQ(force.slip, 0);
  }
  scene.poses[1].t.x() += 0.5;
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

// Whether a tower of stones stands, the k-th from the top over the next by `share` / (2 k) of its
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
  scene.options.step_limit = 2;
  auto world = scene.world(0.7);
  const Vec3 start = world->poses()[0].t;
  const StepReport report = world->settle(
      100, [&](const StepReport&) { return (world->poses()[0].t - start).norm() > 5; });
  EXPECT_TRUE(report.converged);
  return report.at_rest;
}

TEST(KnownAnswers, TowerStandsJustBelowTheHarmonicOverhang) {
  EXPECT_TRUE(tower_stands(20, 0.99));
  EXPECT_FALSE(tower_stands(20, 1.01));
}

TEST(KnownAnswers, AFewOfManyBlocksSettleByThemselves) {
  // 150 blocks lie on a table, 20 mm apart; one of them is pushed.
  Scene scene;
  const int blocks = 150, pushed = 70;
  scene.add(box(8000, 40, 10, {0, -5}), true);
  for (int k = 0; k < blocks; ++k) {
    scene.load(scene.add(box(10, 10, 2, {20.0 * k, 1}), false), {0, 0, -1});
  }
  auto world = scene.world(0.5);
  auto force =
      std::make_unique<PointLoads>(std::vector<PointLoad>{{pushed, Vec3::Zero(), Vec3::Zero()}});
  PointLoads* pushing = force.get();
  world->add(std::move(force));
  ASSERT_TRUE(world->settle(60).at_rest);
  const Poses before = world->poses();
  pushing->loads[0].force = {0.2, 0, 0};
  int steps = 0, factorizations = 0;
  const StepReport last = world->settle(60, [&](const StepReport& step) {
    ++steps;
    factorizations += step.factorizations;
    return false;
  });
  ASSERT_TRUE(last.at_rest);
  EXPECT_GT(steps, 0);
  EXPECT_EQ(factorizations, 0) << "all blocks were asked";
  for (int body = 1; body <= blocks; ++body) {
    const Vec3 way = world->poses()[body].t - before[body].t;
    EXPECT_EQ(way.x() > 1e-6, body == pushed) << body;
  }
  std::vector<double> push(blocks + 1, 0), friction = push;
  for (const TouchForce& touch : world->forces()) {
    push[touch.body[1]] += touch.push;
    friction[touch.body[1]] += touch.friction.x();
  }
  for (int body = 1; body <= blocks; ++body) {
    EXPECT_NEAR(push[body], 1, 1e-6) << body;
    EXPECT_NEAR(friction[body], body == pushed ? -0.2 : 0, 1e-6) << body;
  }
}

TEST(BodyPart, TakesTheFewWithTheLargestForcesAndThoseJoinedToThem) {
  const int count = 300;
  std::vector<RigidBody> bodies(count);
  std::vector<std::vector<int>> joined(count);  // a chain
  for (int i = 0; i + 1 < count; ++i) {
    joined[i].push_back(i + 1);
    joined[i + 1].push_back(i);
  }
  bodies[52].fixed = true;
  Eigen::VectorXd forces = Eigen::VectorXd::Constant(count, 0.01);
  forces(50) = 1;
  forces(200) = 0.5;
  const BodyPart part = worst_part(forces, bodies, joined);
  EXPECT_EQ(part.bodies, (std::vector<int>{50, 200, 49, 51, 199, 201, 48, 52, 198, 202}));
  EXPECT_EQ(part.moving, 6);
  std::array<int, 3> element = {-1, 52, 51};
  EXPECT_TRUE(part.take(element));
  EXPECT_EQ(element, (std::array<int, 3>{-1, 7, 3}));
  std::array<int, 2> still = {52, 53}, far = {100, 101};
  EXPECT_FALSE(part.take(still));
  EXPECT_FALSE(part.take(far));

  EXPECT_EQ(worst_part(Eigen::VectorXd::Ones(count), bodies, joined).moving, 0);
}

TEST(KnownAnswers, ADiscLiftedInAStretchedSheetIsPulledBackAsByAMembraneUnderTension) {
  // A membrane under tension T in a square of half a side s, and a disc of radius a << s in its
  // middle, lifted by w: the capacity of a disc in a square, whose conformal radius is 1.0787 s
  // (G. Polya, G. Szego, Isoperimetric Inequalities in Mathematical Physics, 1951).
  const double a = 5, s = 40, tau = 1.6, lift = 0.2;
  const int corners = 48, side = 20;
  std::vector<Vec2> at;
  std::vector<std::array<int, 2>> edges;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * pi * k / corners;
    at.push_back(a * Vec2(std::cos(angle), std::sin(angle)));
    edges.push_back({k, (k + 1) % corners});
  }
  const Vec2 turn[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int k = 0; k < 4 * side; ++k) {
    at.push_back(s * (turn[k / side] + (turn[(k / side + 1) % 4] - turn[k / side]) *
                                           (static_cast<double>(k % side) / side)));
    edges.push_back({corners + k, corners + (k + 1) % (4 * side)});
  }
  const PlanarMesh mesh = mesh_region(at, edges, {Vec2::Zero()},
                                      [](const Vec2& p) { return std::max(1.0, 0.1 * p.norm()); });
  std::vector<RigidBody> bodies(1);
  bodies[0].fixed = true;
  Poses poses(1);
  poses[0].t.z() = lift;
  std::vector<ReducedMembrane::SheetPoint> points;
  Points2 flat(mesh.points.size(), 2);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec2 p = mesh.points[v];
    flat.row(v) = p.transpose();
    if (v < corners) {
      points.push_back({0, Vec3(p.x(), p.y(), 0)});
      continue;
    }
    points.push_back({static_cast<int>(bodies.size()), Vec3::Zero()});
    bodies.emplace_back();
    bodies.back().fixed = v < at.size();
    poses.push_back({Eigen::Matrix3d::Identity(), Vec3(p.x(), p.y(), 0)});
  }
  const MembraneMaterial material;
  WorldOptions options;
  options.least_unit = 1;
  ContactWorld world(bodies, poses, options);
  world.add(std::make_unique<ReducedMembrane>(points, flat, mesh.triangles, tau, material));
  ASSERT_TRUE(world.settle(60).at_rest);
  // Of a neo-Hookean sheet that is stretched alike in both directions, N / mm.
  const double tension = material.shear_modulus * material.thickness * (1 - std::pow(tau, -6.0));
  const double expected = 2 * pi * tension * lift / std::log(1.0787 * s / a);
  EXPECT_NEAR(-world.given_forces()(0, 2), expected, 0.02 * expected);
}

// A square sheet that lies as it was stretched, by more along y than along x, and pulls twice as
// hard as its material: the neo-Hookean tensions along its sides.
TEST(KnownAnswers, ASheetPullsByItsStretchesAlongXAndY) {
  const double side = 8, tau = 2.5;
  Points2 flat(4, 2);
  flat << 0, 0, side, 0, side, side, 0, side;
  std::vector<ReducedMembrane::SheetPoint> points;
  Poses poses;
  for (int v = 0; v < 4; ++v) {
    points.push_back({v, Vec3::Zero()});
    poses.push_back({Eigen::Matrix3d::Identity(), Vec3(flat(v, 0), flat(v, 1), 0)});
  }
  MembraneMaterial material;
  material.constants.regularization = 0;
  ReducedMembrane sheet(points, flat, {{0, 1, 2}, {0, 2, 3}}, tau, material);
  sheet.pull = 2;
  sheet.stretch = Vec2(0.9, 1.3);
  Motions gradient = Motions::Zero(4, 6);
  sheet.derivatives(poses, 1, gradient, nullptr, 0);
  const Vec2 stretch = tau * sheet.stretch;
  for (int k = 0; k < 2; ++k) {
    const double own = stretch(k), other = stretch(1 - k);
    const double expected = 2 * material.shear_modulus * material.thickness *
                            (own - std::pow(own, -3) * std::pow(other, -2)) * side / other;
    double pulled = 0;
    for (int v = 0; v < 4; ++v) {
      if (flat(v, k) > 0) pulled += gradient(v, k);
    }
    EXPECT_NEAR(pulled, expected, 1e-9 * expected) << k;
  }
}

}  // namespace
}  // namespace curveups::test
