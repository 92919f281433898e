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

TEST(Meeting, ABodyOnAPathPassesNothing) {
  for (bool path : {false, true}) {
    Scene scene = plates();
    scene.load(1, {-1, 0, 0});
    scene.options.step_limit = 20;
    auto world = scene.world(0.5);
    if (path) {
      Pace pace;
      pace.step_limit = 20;
      world->begin_path(pace);
      bool at_rest = false;
      for (int k = 0; k < 100 && !at_rest; ++k) at_rest = world->advance().at_rest;
      EXPECT_TRUE(at_rest);
    } else {
      world->settle(40);
    }
    const double x = world->poses()[1].t.x();
    // It comes to rest on the plate, or is beyond it.
    if (path) {
      EXPECT_NEAR(x, 1, 0.01);
    } else {
      EXPECT_LT(x, -1) << "nothing passed: nothing was tested";
    }
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
    const StepReport step = world->advance();
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
    for (int k = 0; k < 60 && !at_rest; ++k) at_rest = world->advance().at_rest;
    EXPECT_EQ(at_rest, slope < 0.5) << slope;
    EXPECT_EQ(world->poses()[1].t.x() > 5, slope > 0.5) << slope;
  }
}

// A cube whose edge is in another's, deeper along z: its upper face parts them best.
TEST(ContactSearch, FacesThatTouchedStayWithinTheMargin) {
  Scene scene;
  scene.add(box(10, 10, 10, {0, 0}), true);
  scene.add(box(10, 10, 10, {9.9, 9.95}), false);
  SearchOptions options;
  const auto before = find_touching(scene.bodies, scene.poses, options, {});
  ASSERT_EQ(before.size(), 1u);
  scene.poses[1].t += Vec3(0.035, 0, -0.025);  // now along x
  for (double margin : {0.0, 0.005, 0.05}) {
    options.face_margin = margin;
    const auto now = find_touching(scene.bodies, scene.poses, options, before);
    ASSERT_EQ(now.size(), 1u);
    EXPECT_EQ(now[0].face == before[0].face, margin == 0.05) << margin;
  }
}

// The same, to and fro: each return to the faces before makes the pair slower to change.
TEST(ContactSearch, FacesDoNotTakeTurnsForEver) {
  Scene scene;
  scene.add(box(10, 10, 10, {0, 0}), true);
  scene.add(box(10, 10, 10, {9.9, 9.95}), false);
  SearchOptions options;
  for (double margin : {0.0, 0.005}) {
    options.face_margin = margin;
    auto pairs = find_touching(scene.bodies, scene.poses, options, {});
    int changes = 0, late = 0;
    for (int k = 0; k < 40; ++k) {
      const double to = k % 2 ? -1 : 1;
      scene.poses[1].t += to * Vec3(0.06, 0, -0.05);
      const auto face = pairs[0].face;
      pairs = find_touching(scene.bodies, scene.poses, options, pairs);
      ASSERT_EQ(pairs.size(), 1u);
      changes += pairs[0].face != face;
      late += k >= 20 && pairs[0].face != face;
    }
    EXPECT_GE(changes, 2) << margin;
    EXPECT_EQ(late, margin > 0 ? 0 : 20);
  }
}

TEST(ContactSearch, PairsAreEquallyStiffWhereThatIsAskedFor) {
  Scene scene;
  scene.add(box(10, 10, 10, {0, 0}), true);
  scene.add(box(10, 10, 10, {0, 10}), false);
  scene.add(box(10, 10, 10, {9.9, 20}), false);
  SearchOptions options;
  for (double asked : {0.0, 80.0}) {
    options.pair_stiffness = asked;
    std::vector<double> sums;
    for (const TouchingPair& pair : find_touching(scene.bodies, scene.poses, options, {})) {
      double sum = 0;
      for (const Touch& touch : pair.touches) sum += touch.stiffness;
      sums.push_back(sum);
    }
    ASSERT_EQ(sums.size(), 2u);
    if (asked > 0) {
      EXPECT_NEAR(sums[0], asked, 1e-9);
      EXPECT_NEAR(sums[1], asked, 1e-9);
    } else {
      EXPECT_GT(sums[0], 10 * sums[1]);  // by the area that touches
    }
  }
}

}  // namespace
}  // namespace curveups::test
