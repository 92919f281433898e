// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "contact/blocks.hpp"

namespace curveups::test {
namespace {

// A block on a larger one, `gap` above it, turned about the vertical axis.
Scene stacked(double gap, double angle = 0) {
  Scene scene;
  scene.add(box(20, 20, 10, {0, -5}), true);
  scene.add(box(10, 10, 10, {0, 5 + gap}), false);
  scene.poses[1].R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).matrix();
  return scene;
}

std::vector<TouchingPair> touching(const Scene& scene, const SearchOptions& options = {},
                                   const std::vector<TouchingPair>& before = {}) {
  return find_touching(scene.bodies, scene.poses, options, before);
}

TEST(ContactSearch, FacesTouchAtTheCornersOfWhatTheyShare) {
  const Scene scene = stacked(-0.01, 0.3);
  const std::vector<TouchingPair> pairs = touching(scene);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].body, (std::array<int, 2>{0, 1}));
  ASSERT_EQ(pairs[0].touches.size(), 8u);  // four corners, of either body
  double stiffness = 0;
  for (const Touch& touch : pairs[0].touches) {
    const RigidMotion &own = scene.poses[touch.of], &other = scene.poses[1 - touch.of];
    const Vec3 at = own(touch.point), y = other.to_own(at);
    EXPECT_NEAR(std::hypot(at.x(), at.y()), 5 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(touch.gap(y), -0.01, 1e-9);
    EXPECT_NEAR(touch.push(y), 0.01 * touch.stiffness, 1e-9);
    EXPECT_LT(touch.reach(y).norm(), 1e-12);  // friction begins here
    stiffness += touch.stiffness;
  }
  // Two layers in series over the common area.
  EXPECT_NEAR(stiffness, 0.5 * stone_stiffness * 100, 1e-6 * stone_stiffness * 100);
}

TEST(ContactSearch, BodiesTouchWithinReachAlone) {
  SearchOptions options;
  EXPECT_EQ(touching(stacked(0.9 * options.reach)).size(), 1u);
  EXPECT_TRUE(touching(stacked(1.1 * options.reach)).empty());
  // Side by side, edges of their boxes overlap and faces do not.
  Scene scene = stacked(0);
  scene.poses[1].t.x() = 15.1;
  EXPECT_TRUE(touching(scene).empty());
  scene.poses[1].t.x() = 0;
  scene.bodies[1].fixed = true;
  EXPECT_TRUE(touching(scene).empty());
}

TEST(ContactSearch, TipsTouchInPlaceOfTheirFace) {
  Scene scene = stacked(0.2);
  for (BodySurface& face : scene.bodies[1].faces) {
    if (face.normal.z() > -0.9) continue;
    face.tips = {Vec3(3, 0, -5.2), Vec3(40, 0, -5.2)};  // the second one hangs over
    face.tip_stiffness = 7;
  }
  const std::vector<TouchingPair> pairs = touching(scene);
  ASSERT_EQ(pairs.size(), 1u);
  ASSERT_EQ(pairs[0].touches.size(), 1u);
  const Touch& touch = pairs[0].touches[0];
  EXPECT_EQ(touch.of, 1);
  EXPECT_EQ(touch.point.x(), 3);
  EXPECT_EQ(touch.stiffness, 7);
  EXPECT_NEAR(touch.gap(scene.poses[0].to_own(scene.poses[1](touch.point))), 0, 1e-9);
}

TEST(ContactSearch, FrictionsHistoryGoesOnFromTheNearestPoint) {
  Scene scene = stacked(-0.01);
  SearchOptions options;
  std::vector<TouchingPair> before = touching(scene);
  for (Touch& touch : before[0].touches) {
    touch.stretch = Vec2(0.001, 0.002);
    touch.slip = 0.5;
    touch.cap = 3;
  }
  // Corners that are still good stay as they are, others are clipped anew.
  for (const double shift : {0.5 * options.keep, 8.0}) {  // 8: it hangs over
    scene.poses[1].t.x() = shift;
    const std::vector<TouchingPair> now = touching(scene, options, before);
    ASSERT_EQ(now[0].touches.size(), 8u);
    const bool same =
        std::equal(now[0].touches.begin(), now[0].touches.end(), before[0].touches.begin(),
                   [](const Touch& a, const Touch& b) { return a.point == b.point; });
    EXPECT_EQ(same, shift < 1);
    for (std::size_t k = 0; k < 8; ++k) {
      const Touch& touch = now[0].touches[k];
      EXPECT_NEAR(touch.stretch.norm() * touch.tangent_stiffness,
                  before[0].touches[k].stretch.norm() * before[0].touches[k].tangent_stiffness,
                  1e-9)
          << k;
      EXPECT_EQ(touch.slip, 0.5);
      EXPECT_EQ(touch.cap, 3);
    }
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
      EXPECT_GT(sums[0], 10 * sums[1]);  // sums follow the area that touches
    }
  }
}

}  // namespace
}  // namespace curveups::test
