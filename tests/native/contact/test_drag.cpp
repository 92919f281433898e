// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/blocks.hpp"
#include "curveups/contact/drag.hpp"

namespace curveups::test {
namespace {

constexpr double lever = 3;

Poses some_poses() {
  Poses poses;
  for (int i = 0; i < 4; ++i) {
    poses.push_back(
        {Eigen::AngleAxisd(0.4 + i, Vec3(1, 2 - i, 0.5).normalized()).toRotationMatrix(),
         Vec3(6.0 * i, -4 * i * i, 7)});
  }
  return poses;
}

// All bodies turned about one axis through a point that is far from them.
Poses turned(const Poses& poses, double angle) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Vec3(1, 1, -2).normalized()).matrix();
  const Vec3 centre(-80, 20, 5);
  Poses out;
  for (const RigidMotion& pose : poses) {
    out.push_back({R * pose.R, centre + R * (pose.t - centre)});
  }
  return out;
}

double largest_difference(const Poses& a, const Poses& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max({most, (a[i].t - b[i].t).norm(), (a[i].R - b[i].R).norm()});
  }
  return most;
}

Drag some_drag(const Poses& from, double lone) {
  return {{{{0, 1}, 0}, {{1, 2}, 1}, {{1, 3}, 2}}, from, lever, lone};
}

TEST(Motions, BodiesThatTurnAsOneStayAsTheyAreToOneAnother) {
  const Poses from = some_poses();
  for (double angle : {1e-5, 1e-3, 0.5, 2.5}) {
    // The velocity of each origin, about the common axis.
    const Vec3 turn = angle * Vec3(1, 1, -2).normalized(), centre(-80, 20, 5);
    Motions motions(4, 6);
    for (int i = 0; i < 4; ++i) {
      motions.row(i) << turn.cross(from[i].t - centre).transpose(), lever * turn.transpose();
    }
    EXPECT_LT(largest_difference(moved(from, motions, lever), turned(from, angle)), 1e-12) << angle;
  }
}

TEST(Drag, HasExactDerivativesAwayFromWhereItBegan) {
  const Poses from = some_poses();
  const std::vector<Coupling> couplings{{0, 1}, {1, 2}, {1, 3}};
  BlockMatrix<6> hessian(std::make_shared<const BlockPattern>(std::vector<char>(4, 1), couplings));
  const MotionHessian second{&hessian, 0, false};
  const Drag drag = some_drag(from, 0.03);
  for (double far : {0.0, 0.3}) {  // rad, and as one by far more
    const Poses at = moved(turned(from, 3 * far), far * lever * Motions::Random(4, 6), lever);
    const Motions d = Motions::Random(4, 6);
    Motions gradient = Motions::Zero(4, 6);
    hessian.set_zero();
    EXPECT_NEAR(drag.derivatives(at, 5, gradient, &second), drag.value(at, 5), 1e-10);
    auto along = [&](double h) { return drag.value(moved(at, h * d, lever), 5); };
    const double h = 1e-5;
    EXPECT_NEAR(gradient.cwiseProduct(d).sum(), (along(h) - along(-h)) / (2 * h),
                1e-8 * (1 + gradient.norm()));
    if (far > 0) continue;
    const Eigen::VectorXd flat = Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
    const double product = flat.dot(hessian.multiply(flat).col(0)) + 5 * 0.03 * d.squaredNorm();
    const double g = 1e-3;
    EXPECT_NEAR(product, (along(g) - 2 * along(0) + along(-g)) / (g * g), 1e-5 * product);
  }
}

TEST(Drag, DoesNotResistWhatMovesAsOne) {
  const Poses from = some_poses(), far = turned(from, 1.2);
  const Drag drag = some_drag(from, 0);
  EXPECT_GT((far[0].t - from[0].t).norm(), 50);
  EXPECT_LT(drag.furthest_apart(far), 1e-6);
  EXPECT_LT(drag.value(far, 5), 1e-11);
  // Body that turns by 0.1 about halfway to its neighbour.
  Poses alone = from;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1, Vec3(0.6, 0, 0.8)).matrix();
  const Vec3 half = 0.5 * (from[0].t + from[1].t);
  alone[0] = {turn * from[0].R, half + turn * (from[0].t - half)};
  const double chord = 2 * lever * std::sin(0.05);
  EXPECT_NEAR(drag.furthest_apart(alone), chord, 1e-9);
  EXPECT_NEAR(drag.value(alone, 5), 0.5 * 5 * chord * chord, 1e-9);
  const Motions little = 1e-6 * Motions::Random(4, 6);
  EXPECT_NEAR(drag.furthest_apart(from, little) / drag.furthest_apart(moved(from, little, lever)),
              1, 1e-3);
}

TEST(Drag, BodiesOnAPathGoFurtherTogetherThanOneBesideTheOther) {
  const Pace pace;
  for (bool together : {false, true}) {
    Scene scene;
    scene.add(box(10, 10, 2, {0, 0}), false);
    scene.add(box(10, 10, 2, {10, 0}), false);
    scene.load(0, {-1, 0, 0});
    scene.load(1, {together ? -1.0 : 1.0, 0, 0});
    auto world = scene.world(0.5);
    world->begin_path(pace);
    double furthest = 0;  // in a step; apart they are neighbours in the first one alone
    for (int k = 0; k < (together ? 13 : 1); ++k) {
      const Poses before = world->poses();
      world->step();
      furthest = std::max(furthest, largest_motion(motions_between(before, world->poses(), lever)));
    }
    if (!together) {
      EXPECT_GT(furthest, 0.2 * pace.step_limit);
      EXPECT_LT(furthest, pace.step_limit);
      continue;
    }
    EXPECT_GT(furthest, pace.together * pace.step_limit);
    EXPECT_LE(furthest, 2 * pace.together * pace.step_limit * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace curveups::test
