// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <cmath>
#include <typeinfo>

#include "contact/blocks.hpp"
#include "curveups/contact/tile_world.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

// Position of each origin that goes straight on.
Poses straight(const Poses& poses, const Motions& motions, double lever) {
  Poses out = moved(poses, motions, lever);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    out[i].t = poses[i].t + motions.row(i).head<3>().transpose();
  }
  return out;
}

// With two couplings of others before the energy's own.
Eigen::MatrixXd second_derivatives(const MotionEnergy& energy, const Poses& poses, bool projected) {
  std::vector<Coupling> couplings(2, Coupling{0, 0});
  energy.couple(couplings);
  const int count = static_cast<int>(poses.size());
  BlockMatrix<6> matrix(
      std::make_shared<const BlockPattern>(std::vector<char>(count, 1), couplings));
  const MotionHessian hessian{&matrix, 2, projected};
  Motions gradient = Motions::Zero(count, 6);
  energy.derivatives(poses, 3, gradient, &hessian);
  return matrix.multiply(Eigen::MatrixXd::Identity(6 * count, 6 * count));
}

// Derivatives by small motions: of first order against values, of second order against second
// differences of values along straight motions.
void expect_derivatives(const MotionEnergy& energy, const Poses& poses) {
  SCOPED_TRACE(typeid(energy).name());
  const double lever = 3;
  const Eigen::MatrixXd hessian = second_derivatives(energy, poses, false);
  Motions gradient = Motions::Zero(poses.size(), 6);
  EXPECT_NEAR(energy.derivatives(poses, lever, gradient, nullptr), energy.value(poses),
              1e-12 * (1 + std::abs(energy.value(poses))));
  ASSERT_GT(gradient.norm(), 0) << "constant: nothing was tested";
  for (int round = 0; round < 6; ++round) {
    const Motions d = Motions::Random(poses.size(), 6);
    auto along = [&](double h) { return energy.value(moved(poses, h * d, lever)); };
    const double h = 1e-6;
    EXPECT_NEAR(gradient.cwiseProduct(d).sum(), (along(h) - along(-h)) / (2 * h),
                1e-6 * gradient.norm() * d.norm());
    auto straight_on = [&](double g) { return energy.value(straight(poses, g * d, lever)); };
    const double g = 1e-4;
    const double second = (straight_on(g) - 2 * straight_on(0) + straight_on(-g)) / (g * g);
    const Eigen::VectorXd flat = Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
    const double product = flat.dot(hessian * flat);
    EXPECT_NEAR(product, second, 1e-5 * (std::abs(product) + gradient.norm() * d.squaredNorm()));
  }
}

// Forces and torques that bodies exert on one another: their sums over all bodies.
void expect_balance(const MotionEnergy& energy, const Poses& poses) {
  const double lever = 3;
  Motions gradient = Motions::Zero(poses.size(), 6);
  energy.derivatives(poses, lever, gradient, nullptr);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double mean = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 f = gradient.row(i).head<3>(), m = lever * gradient.row(i).tail<3>().transpose();
    force += f;
    torque += m + poses[i].t.cross(f);
    mean += f.norm() / static_cast<double>(poses.size());
  }
  ASSERT_GT(mean, 0);
  EXPECT_LT(force.norm(), 1e-9 * mean);
  EXPECT_LT(torque.norm(), 1e-9 * mean * 100);  // arms of some 100 mm
}

Poses turned_poses(int count) {
  Poses poses;
  for (int i = 0; i < count; ++i) {
    poses.push_back(
        {Eigen::AngleAxisd(0.4 + i, Vec3(1, 2 - i, 0.5).normalized()).toRotationMatrix(),
         Vec3(20 + 3 * i, -4 * i, 7)});
  }
  return poses;
}

// Two blocks, one pressed into the other and turned a little; some points slip and some stick.
struct Pressed {
  Poses poses;
  ContactEnergy energy;

  explicit Pressed(const Eigen::Matrix3d& where) {
    Scene scene;
    scene.add(box(20, 20, 10, {0, -5}), false);
    scene.add(box(10, 10, 10, {2, 5}), false);
    SearchOptions options;
    energy.pairs = find_touching(scene.bodies, scene.poses, options, {});
    energy.couple_pairs();
    Motions motion = Motions::Zero(2, 6);
    motion.row(1) << 0.02, 0.03, -0.04, 0.01, 0.02, 0.015;
    poses = moved(scene.poses, motion, 3);
    for (RigidMotion& pose : poses) pose = {where * pose.R, where * pose.t + Vec3(3, 4, 5)};
    energy.friction_coefficient = 0.25;
    energy.lag_friction(poses);
    std::vector<Touch>& touches = energy.pairs[0].touches;
    for (std::size_t k = 0; k < touches.size(); k += 3) touches[k].cap = 1e3;
  }
};

TEST(MotionEnergy, ContactHasExactDerivativesAndBalances) {
  const Pressed pressed(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  ASSERT_EQ(pressed.energy.pairs.size(), 1u);
  EXPECT_EQ(pressed.energy.pairs[0].touches.size(), 8u);
  expect_derivatives(pressed.energy, pressed.poses);
  expect_balance(pressed.energy, pressed.poses);
}

TEST(MotionEnergy, ProjectedSecondDerivativesNeverLeadUpwards) {
  const Pressed pressed(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  std::array<double, 2> lowest{};
  for (const bool projected : {false, true}) {
    const Eigen::MatrixXd matrix = second_derivatives(pressed.energy, pressed.poses, projected);
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    lowest[projected] = eigenvalues(0) / eigenvalues(11);
  }
  EXPECT_LT(lowest[0], -1e-6) << "nothing was indefinite: nothing was tested";
  EXPECT_GT(lowest[1], -1e-12);
}

TEST(MotionEnergy, PositiveTurnCurvatureLacksTheNegativeEigenvalues) {
  const double lever = 3;
  const Vec3 arm(1, -2, 0.5), across = arm.unitOrthogonal();
  const Vec3 forces[] = {{3, 1, 2}, {-3, 1, -2},          2 * arm,     -2 * arm,
                         across,    -arm + 1e-9 * across, Vec3::Zero()};
  for (const Vec3& force : forces) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(turn_curvature(force, arm, lever));
    const Eigen::Matrix3d wanted = eigen.eigenvectors() *
                                   eigen.eigenvalues().cwiseMax(0).asDiagonal() *
                                   eigen.eigenvectors().transpose();
    EXPECT_LT((positive_turn_curvature(force, arm, lever) - wanted).norm(),
              1e-12 * force.norm() + 1e-300)
        << force.transpose();
  }
}

TEST(MotionEnergy, MembranesHaveExactDerivativesAndBalance) {
  const Design design = sample_design();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const TileMesh& tiles = geometry.tiles;
  const Points3 centres = tile_centres(tiles);
  for (const DensityModel& model : density_models()) {
    const Side side = model.name == "neo-hookean" ? Side::back : Side::front;
    const MembraneDomain domain = make_membrane_domain(tiles, side);
    const Points3 corners = actuated_pin_corners(tiles, design.q, side, design.parameters.H_pin);
    Points3 own = corners;
    for (int c = 0; c < own.rows(); ++c) own.row(c) -= centres.row(c / 3);
    MembraneMaterial material;
    material.model = &model;
    const ReducedMembrane membrane(
        domain, flat_pin_corners(tiles, fit_poses(tiles, design.T), design.q, side), own,
        design.parameters.tau, material, tiles.tile_count());
    Poses poses(tiles.tile_count());
    for (int i = 0; i < tiles.tile_count(); ++i) poses[i].t = centres.row(i).transpose();
    const Poses nodes = membrane_nodes(domain, corners);
    ASSERT_GT(nodes.size(), 0u);
    poses.insert(poses.end(), nodes.begin(), nodes.end());
    const Motions away = 0.1 * Motions::Random(poses.size(), 6);
    poses = moved(poses, away, 3);
    expect_derivatives(membrane, poses);
    expect_balance(membrane, poses);
  }
}

TEST(MotionEnergy, GivenForcesHaveExactDerivatives) {
  const Poses poses = turned_poses(3);
  const PointLoads loads({{0, {1, 2, 3}, {0.5, -1, 2}}, {2, {-2, 0, 1}, {1, 1, 1}}});
  expect_derivatives(loads, poses);
  const PairLoads pairs({{{0, 1}, {1, -2, 0.5}, {2, 1, -1}},
                         {{0, 1}, {-1, 1, 2}, {0.5, -3, 1}},
                         {{1, 2}, {0, 3, 1}, {-1, 0.5, 1}}});
  expect_derivatives(pairs, poses);
  expect_balance(pairs, poses);
}

}  // namespace
}  // namespace curveups::test
