// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/blocks.hpp"
#include "curveups/contact/meeting.hpp"

namespace curveups::test {
namespace {

// A fixed plate at x = 0 and one at x = 3, both 1 mm thick.
Scene plates() {
  Scene scene;
  scene.add(box(1, 20, 20, {0, 0}), true);
  scene.add(box(1, 20, 20, {3, 0}), false);
  return scene;
}

Poses shifted(const Scene& scene, double by) {
  Poses poses = scene.poses;
  poses[1].t.x() += by;
  return poses;
}

TEST(Meeting, SeesWhatPassesBetweenTwoPosesThatAreApart) {
  const Scene scene = plates();
  EXPECT_TRUE(could_pass(scene.bodies, scene.poses, shifted(scene, -6)));
  EXPECT_TRUE(could_pass(scene.bodies, scene.poses, shifted(scene, -2.2)));
  EXPECT_FALSE(could_pass(scene.bodies, scene.poses, shifted(scene, -0.4)));
  // Far from everything a step may be long.
  EXPECT_FALSE(could_pass(scene.bodies, scene.poses, shifted(scene, 50)));
}

TEST(Meeting, SeesTheCornerOfABodyThatTurnsOnTheSpot) {
  const Scene scene = plates();
  Poses turned = scene.poses;
  turned[1].R = Eigen::AngleAxisd(3.1, Vec3::UnitY()).toRotationMatrix();
  EXPECT_TRUE(could_pass(scene.bodies, scene.poses, turned));
}

TEST(Meeting, ABodyThatTakesLongStepsPassesNothing) {
  for (bool path : {false, true}) {
    Scene scene = plates();
    scene.load(1, {-1, 0, 0});
    Pace pace = path ? Pace() : Pace::settling();
    pace.step_limit = 20;
    scene.options.pace = pace;
    auto world = scene.world(0.5);
    EXPECT_TRUE(world->settle(100).at_rest) << path;
    EXPECT_NEAR(world->poses()[1].t.x(), 1, 0.01) << path;  // rest on the plate
  }
}

TEST(Meeting, EnergyFallsByWhatFrictionAndDragTake) {
  Scene scene;
  scene.add(box(200, 40, 10, {0, -5}), true);
  scene.add(box(10, 10, 2, {0, 1}), false);
  scene.load(1, {0.8, 0, -1});
  auto world = scene.world(0.5);
  world->begin_path({});
  double friction = 0, way = 0;
  for (int k = 0; k < 40; ++k) {
    const double x = world->poses()[1].t.x();
    const StepReport step = world->step();
    EXPECT_GE(step.friction, 0);
    EXPECT_LE(step.energy + step.friction, step.before + 1e-6);
    friction += step.friction;
    way += world->poses()[1].t.x() - x;
  }
  ASSERT_GT(way, 10);
  EXPECT_NEAR(friction, 0.5 * way, 0.02 * way);  // mu N along the way
}

TEST(Meeting, ABlockOnAPathStaysOnASlopeThatFrictionHolds) {
  for (double slope : {0.4, 0.6}) {
    Scene scene;
    scene.add(box(200, 40, 10, {0, -5}), true);
    scene.add(box(10, 10, 2, {0, 1}), false);
    scene.load(1, {slope, 0, -1});
    auto world = scene.world(0.5);
    world->begin_path({});
    bool at_rest = false;
    for (int k = 0; k < 60 && !at_rest; ++k) at_rest = world->step().at_rest;
    EXPECT_EQ(at_rest, slope < 0.5) << slope;
    EXPECT_EQ(world->poses()[1].t.x() > 5, slope > 0.5) << slope;
  }
}

}  // namespace
}  // namespace curveups::test
