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

TEST(Motions, LeadFromOnePoseToTheOther) {
  const Poses from = some_poses();
  for (double size : {1e-9, 1e-5, 1e-3, 1.0, 5.0}) {
    const Motions motions = size * Motions::Random(4, 6);
    const Poses to = moved(from, motions, lever);
    EXPECT_LT((motions_between(from, to, lever) - motions).norm(), 1e-7 * size + 1e-13) << size;
    EXPECT_LT(largest_difference(moved(from, motions_between(from, to, lever), lever), to), 1e-11);
  }
  const Poses far = turned(from, 2.5);
  EXPECT_LT(largest_difference(moved(from, motions_between(from, far, lever), lever), far), 1e-10);
}

TEST(Motions, HalfAWayOfBodiesThatTurnAsOneLeavesThemAsTheyAre) {
  const Poses from = some_poses();
  const Motions whole = motions_between(from, turned(from, 1.0), lever);
  EXPECT_LT(largest_difference(moved(from, 0.5 * whole, lever), turned(from, 0.5)), 1e-12);
}

TEST(Drag, HasExactDerivatives) {
  const Poses from = some_poses();
  const std::vector<Coupling> couplings{{0, 1}, {1, 2}, {3, 1}};
  BlockMatrix<6> hessian(std::make_shared<const BlockPattern>(std::vector<char>(4, 1), couplings));
  const Drag drag({{{0, 1}, 0}, {{1, 2}, 1}, {{3, 1}, 2}}, from, lever, 0.03);
  const Motions at = Motions::Random(4, 6), d = Motions::Random(4, 6);
  Motions gradient = Motions::Zero(4, 6);
  hessian.set_zero();
  EXPECT_NEAR(drag.derivatives(at, 5, gradient, &hessian), drag.value(at, 5), 1e-12);
  // Quadratic: differences are exact.
  const double forward = drag.value(at + d, 5), backward = drag.value(at - d, 5);
  EXPECT_NEAR(gradient.cwiseProduct(d).sum(), 0.5 * (forward - backward), 1e-10);
  const Eigen::VectorXd flat = Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
  const double second = flat.dot(hessian.multiply(flat).col(0)) + 5 * 0.03 * d.squaredNorm();
  EXPECT_NEAR(second, forward - 2 * drag.value(at, 5) + backward, 1e-10);
}

TEST(Drag, HardlyResistsWhatMovesAsOne) {
  const Poses from = some_poses();
  const Drag drag({{{0, 1}, 0}, {{1, 2}, 1}, {{2, 3}, 2}}, from, lever, 0);
  const Motions together = motions_between(from, turned(from, 0.3), lever);
  EXPECT_GT(together.row(0).head<3>().norm(), 20);
  EXPECT_LT(drag.furthest_apart(together), 1e-12);
  EXPECT_LT(drag.value(together, 5), 1e-20);
  // One that turns by 0.1 about halfway to its neighbour.
  Motions alone = Motions::Zero(4, 6);
  const Vec3 turn(0.06, 0, 0.08), to_half = 0.5 * (from[1].t - from[0].t);
  alone.row(0) << -turn.cross(to_half).transpose(), lever * turn.transpose();
  EXPECT_NEAR(drag.furthest_apart(alone), lever * 0.1, 1e-12);
  EXPECT_NEAR(drag.value(alone, 5), 0.5 * 5 * 0.09, 1e-12);
}

}  // namespace
}  // namespace curveups::test
