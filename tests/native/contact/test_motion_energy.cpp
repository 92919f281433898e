// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <typeinfo>

#include "contact/blocks.hpp"
#include "curveups/contact/reduced_membrane.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

// Where each origin goes straight on.
Poses straight(const Poses& poses, const Motions& motions, double lever) {
  Poses out = moved(poses, motions, lever);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    out[i].t = poses[i].t + motions.row(i).head<3>().transpose();
  }
  return out;
}

// Derivatives by small motions: of first order against values, of second order against second
// differences of values along straight motions.
void expect_derivatives(const MotionEnergy& energy, const Poses& poses) {
  SCOPED_TRACE(typeid(energy).name());
  const double lever = 3;
  std::vector<Coupling> couplings(2, Coupling{0, 0});
  energy.couple(couplings);
  BlockMatrix<6> hessian(
      std::make_shared<const BlockPattern>(std::vector<char>(poses.size(), 1), couplings));
  Motions gradient = Motions::Zero(poses.size(), 6);
  EXPECT_NEAR(energy.derivatives(poses, lever, gradient, &hessian, 2), energy.value(poses),
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
    const double product = flat.dot(hessian.multiply(flat).col(0));
    EXPECT_NEAR(product, second, 1e-5 * (std::abs(product) + gradient.norm() * d.squaredNorm()));
  }
}

// Forces and torques that bodies exert on one another: their sums over all bodies.
void expect_balance(const MotionEnergy& energy, const Poses& poses) {
  const double lever = 3;
  Motions gradient = Motions::Zero(poses.size(), 6);
  energy.derivatives(poses, lever, gradient, nullptr, 0);
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

// A part with one body that moves feels what that body feels of the whole.
void expect_parts(const MotionEnergy& energy, const Poses& poses) {
  const double lever = 3;
  const int count = static_cast<int>(poses.size());
  std::vector<Coupling> couplings;
  energy.couple(couplings);
  Motions whole = Motions::Zero(count, 6);
  energy.derivatives(poses, lever, whole, nullptr, 0);
  for (int moving = 0; moving < std::min(count, 12); ++moving) {
    BodyPart part;
    part.number.assign(count, -1);
    part.moving = 1;
    const auto take = [&](int body) {
      if (body < 0 || part.number[body] >= 0) return;
      part.number[body] = static_cast<int>(part.bodies.size());
      part.bodies.push_back(body);
    };
    take(moving);
    for (const auto& [i, j] : couplings) {
      if (i == moving) take(j);
      if (j == moving) take(i);
    }
    Poses places;
    for (int body : part.bodies) places.push_back(poses[body]);
    Motions own = Motions::Zero(places.size(), 6);
    energy.part(part)->derivatives(places, lever, own, nullptr, 0);
    EXPECT_LT((own.row(0) - whole.row(moving)).norm(), 1e-12 * (1 + whole.norm())) << moving;
  }
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
    Eigen::VectorXd caps = 0.5 * energy.caps_at(poses);
    for (Eigen::Index k = 0; k < caps.size(); k += 3) caps(k) = 1e3;
    energy.set_caps(caps);
  }
};

TEST(MotionEnergy, ContactHasExactDerivativesAndBalances) {
  const Pressed pressed(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  ASSERT_EQ(pressed.energy.pairs.size(), 1u);
  EXPECT_EQ(pressed.energy.pairs[0].touches.size(), 8u);
  expect_derivatives(pressed.energy, pressed.poses);
  expect_balance(pressed.energy, pressed.poses);
  expect_parts(pressed.energy, pressed.poses);
}

TEST(MotionEnergy, ConvexSecondDerivativesNeverLeadUpwards) {
  Pressed pressed(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  std::vector<Coupling> couplings;
  pressed.energy.couple(couplings);
  const auto pattern = std::make_shared<const BlockPattern>(std::vector<char>(2, 1), couplings);
  std::array<double, 3> lowest{};
  std::array<Eigen::MatrixXd, 3> matrix;
  for (int k = 0; k < 3; ++k) {
    pressed.energy.convex = 0.5 * k;
    BlockMatrix<6> hessian(pattern);
    Motions gradient = Motions::Zero(2, 6);
    pressed.energy.derivatives(pressed.poses, 3, gradient, &hessian, 0);
    matrix[k] = hessian.multiply(Eigen::MatrixXd::Identity(12, 12));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix[k]);
    lowest[k] = eigen.eigenvalues()(0) / eigen.eigenvalues()(11);
  }
  EXPECT_LT(lowest[0], -1e-6) << "nothing was indefinite: nothing was tested";
  EXPECT_GT(lowest[1], lowest[0]);
  EXPECT_GT(lowest[2], -1e-12);
  EXPECT_LT((matrix[0] + matrix[2] - 2 * matrix[1]).norm(), 1e-12 * matrix[0].norm());
}

// Points that slip, as springs through their present force, are never softer than they are.
TEST(MotionEnergy, CarefulSecondDerivativesBoundExactOnesFromAbove) {
  Pressed pressed(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  std::vector<Coupling> couplings;
  pressed.energy.couple(couplings);
  const auto pattern = std::make_shared<const BlockPattern>(std::vector<char>(2, 1), couplings);
  std::array<Eigen::MatrixXd, 2> matrix;
  for (bool careful : {false, true}) {
    pressed.energy.careful = careful;
    BlockMatrix<6> hessian(pattern);
    Motions gradient = Motions::Zero(2, 6);
    pressed.energy.derivatives(pressed.poses, 3, gradient, &hessian, 0);
    matrix[careful] = hessian.multiply(Eigen::MatrixXd::Identity(12, 12));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> more(matrix[1] - matrix[0]);
  EXPECT_GT(more.eigenvalues()(11), 1e-3 * matrix[0].norm()) << "nothing slips";
  EXPECT_GT(more.eigenvalues()(0), -1e-12 * matrix[0].norm());
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

TEST(MotionEnergy, GluedContactHasExactDerivatives) {
  Pressed pressed(Eigen::Matrix3d::Identity());
  ContactEnergy& energy = pressed.energy;
  energy.set_caps(energy.caps().setConstant(std::numeric_limits<double>::infinity()));
  const double pushed = energy.value(pressed.poses);
  energy.glued = true;
  expect_derivatives(energy, pressed.poses);
  // Corners that have been lifted pull as well.
  pressed.poses[1].t.z() += 1;
  EXPECT_GT(energy.value(pressed.poses), pushed);
  expect_derivatives(energy, pressed.poses);
}

TEST(MotionEnergy, LimitsOfFrictionAreThoseAfterSmallMotions) {
  const double lever = 3, h = 1e-6;
  Pressed pressed(Eigen::AngleAxisd(0.7, Vec3::UnitX()).toRotationMatrix());
  ContactEnergy& energy = pressed.energy;
  const Eigen::VectorXd caps = energy.caps(), here = energy.caps_at(pressed.poses);
  ASSERT_GT((here.array() > 0).count(), 1);
  const Motions d = Motions::Random(2, 6);
  const Eigen::VectorXd there = energy.caps_at(moved(pressed.poses, h * d, lever));
  ASSERT_GT((there - here).norm(), 0);
  EXPECT_LT((energy.caps_after(pressed.poses, lever, h * d) - there).norm(),
            1e-4 * (there - here).norm());
  // What has been lifted off pushes no more.
  Motions away = Motions::Zero(2, 6);
  away.row(1).head<3>() = 5 * (pressed.poses[1].R * Vec3::UnitZ()).transpose();
  EXPECT_EQ(energy.caps_after(pressed.poses, lever, away).maxCoeff(), 0);

  // Points that slip take the new limits, those that stick don't feel them.
  Motions before = Motions::Zero(2, 6), after = before;
  energy.derivatives(pressed.poses, lever, before, nullptr, 0);
  Motions predicted = before;
  energy.add_caps(pressed.poses, lever, 0.9 * caps, predicted);
  energy.set_caps(0.9 * caps);
  energy.derivatives(pressed.poses, lever, after, nullptr, 0);
  ASSERT_GT((after - before).norm(), 1e-3 * before.norm());
  EXPECT_LT((after - predicted).norm(), 1e-12 * before.norm());
}

TEST(MotionEnergy, ContactDoesNotSeeAMotionOfAll) {
  const Pressed here(Eigen::Matrix3d::Identity());
  const Pressed there(Eigen::AngleAxisd(2, Vec3(1, -2, 3).normalized()).toRotationMatrix());
  EXPECT_GT(here.energy.value(here.poses), 0);
  EXPECT_NEAR(here.energy.value(here.poses), there.energy.value(there.poses), 1e-9);
}

TEST(MotionEnergy, ReportedForcesAreThoseOfTheEnergy) {
  const Pressed pressed(Eigen::AngleAxisd(0.7, Vec3::UnitX()).toRotationMatrix());
  Motions gradient = Motions::Zero(2, 6);
  pressed.energy.derivatives(pressed.poses, 3, gradient, nullptr, 0);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const TouchForce& touch : pressed.energy.forces(pressed.poses)) {
    const Vec3 f = touch.push * touch.normal + touch.friction;
    force += f;
    torque += (touch.position - pressed.poses[1].t).cross(f);
  }
  EXPECT_LT((force + gradient.row(1).head<3>().transpose()).norm(), 1e-9 * force.norm());
  EXPECT_LT((torque + 3 * gradient.row(1).tail<3>().transpose()).norm(), 1e-9 * torque.norm());
}

TEST(MotionEnergy, MembranesHaveExactDerivativesAndBalance) {
  const Design design = sample_design();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const TileMesh& tiles = geometry.tiles;
  const Points3 centres = tile_centres(tiles);
  for (const DensityModel& model : density_models()) {
    const Side side = model.convex ? Side::front : Side::back;
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
    for (const std::vector<int>& polygon : membrane.polygons()) {
      poses.emplace_back();
      for (int c : polygon) {
        poses.back().t += corners.row(c).transpose() / static_cast<double>(polygon.size());
      }
    }
    ASSERT_GT(membrane.polygons().size(), 0u);
    const Motions away = 0.1 * Motions::Random(poses.size(), 6);
    poses = moved(poses, away, 3);
    expect_derivatives(membrane, poses);
    expect_balance(membrane, poses);
    expect_parts(membrane, poses);
  }
}

TEST(MotionEnergy, AnySheetHasExactDerivativesAndBalances) {
  // A square of tau 1.6 in four triangles round a node: two corners on one body, two on others, and
  // a triangle that is all one body's.
  const std::vector<ReducedMembrane::SheetPoint> points = {{0, {-5, -1, 0.4}}, {0, {5, 0.5, -0.3}},
                                                           {1, {1, 1, 0.2}},   {2, {0, -1, 0.6}},
                                                           {3, Vec3::Zero()},  {0, {0, -4, 0.2}}};
  Points2 flat(6, 2);
  flat << 0, 0, 10, 0, 10, 10, 0, 10, 5, 5, 5, -4;
  Poses poses(4);
  poses[0].t = {5, 1, 1};
  poses[1].t = {9, 9, 0.5};
  poses[2].t = {0, 11, -1};
  poses[3].t = {5.5, 4.5, 2};
  const Motions away = 0.2 * Motions::Random(4, 6);
  poses = moved(poses, away, 3);
  for (const DensityModel& model : density_models()) {
    MembraneMaterial material;
    material.model = &model;
    const ReducedMembrane sheet(
        points, flat, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {5, 1, 0}}, 1.6, material);
    expect_derivatives(sheet, poses);
    expect_balance(sheet, poses);
  }
}

TEST(MotionEnergy, GivenForcesHaveExactDerivatives) {
  const Poses poses = turned_poses(3);
  const PointLoads loads({{0, {1, 2, 3}, {0.5, -1, 2}}, {2, {-2, 0, 1}, {1, 1, 1}}});
  expect_derivatives(loads, poses);
  expect_parts(loads, poses);
  const PairLoads pairs({{{0, 1}, {1, -2, 0.5}, {2, 1, -1}},
                         {{0, 1}, {-1, 1, 2}, {0.5, -3, 1}},
                         {{1, 2}, {0, 3, 1}, {-1, 0.5, 1}}});
  expect_derivatives(pairs, poses);
  expect_balance(pairs, poses);
  expect_parts(pairs, poses);
}

}  // namespace
}  // namespace curveups::test
