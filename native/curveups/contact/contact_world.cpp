// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/contact_world.hpp"

#include <algorithm>
#include <utility>

namespace curveups {

ContactWorld::ContactWorld(std::vector<RigidBody> bodies, Poses start, const WorldOptions& options)
    : bodies_(std::move(bodies)), poses_(std::move(start)), options_(options) {}

void ContactWorld::set_poses(const Poses& poses) {
  poses_ = poses;
  given_at_.clear();
  searched_ = false;
  weight_ = -1;
}

void ContactWorld::set_bodies(std::vector<RigidBody> bodies) {
  changed_ = true;
  bodies_ = std::move(bodies);
  contacts_.forget_corners();
  searched_ = false;
}

void ContactWorld::restore(State state) {
  contacts_.pairs = std::move(state.pairs);
  set_poses(state.poses);
  weight_ = state.weight;
}

void ContactWorld::make_pattern() {
  std::vector<Coupling> couplings;
  first_.clear();
  for (const auto& energy : energies_) {
    first_.push_back(static_cast<int>(couplings.size()));
    energy->couple(couplings);
  }
  first_.push_back(static_cast<int>(couplings.size()));
  contacts_.couple(couplings);
  std::vector<char> free;
  std::vector<int> unknowns;  // a point does not turn
  for (const RigidBody& body : bodies_) {
    free.push_back(!body.fixed);
    unknowns.push_back(body.is_point() ? 3 : 6);
  }
  hessian_ = std::make_unique<BlockMatrix<6>>(
      std::make_shared<const BlockPattern>(free, couplings), unknowns);
  given_at_.clear();
  joined_to_.clear();
}

// Bodies that the energies join, and those around a point: these depend on one another once it is
// eliminated, so that their places in the pattern cost little, and it need not change when they
// touch.
std::vector<std::array<int, 2>> ContactWorld::joined_pairs() const {
  std::vector<Coupling> couplings;
  for (const auto& energy : energies_) energy->couple(couplings);
  std::vector<std::array<int, 2>> pairs;
  auto join = [&](int i, int j) {
    if (bodies_[i].can_touch(bodies_[j])) pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  std::vector<std::vector<int>> around(bodies_.size());
  for (const auto& [i, j] : couplings) {
    if (i < 0 || j < 0 || i == j || (bodies_[i].is_point() && bodies_[j].is_point())) continue;
    if (!bodies_[i].is_point() && !bodies_[j].is_point()) {
      join(i, j);
    } else {
      const auto [point, body] = bodies_[i].is_point() ? std::pair(i, j) : std::pair(j, i);
      around[point].push_back(body);
    }
  }
  for (const std::vector<int>& list : around) {
    for (int i : list) {
      for (int j : list) {
        if (i < j) join(i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void ContactWorld::search() {
  contacts_.pairs = find_touching(bodies_, poses_, options_.search, contacts_.pairs);
  // The pattern and its order of elimination stay as long as no new pair touches.
  if (!joined_) joined_ = joined_pairs();
  if (contacts_.couple_pairs(*joined_) || !hessian_) {
    places_.resize(bodies_.size(), 3);
    for (std::size_t i = 0; i < bodies_.size(); ++i) places_.row(i) = poses_[i].t.transpose();
    make_pattern();
  }
  double stiffest = 0, furthest = 0;
  for (const TouchingPair& pair : contacts_.pairs) {
    double sum = 0;
    for (const Touch& touch : pair.touches) sum += touch.stiffness;
    stiffest = std::max(stiffest, sum);
  }
  for (const RigidMotion& pose : poses_) furthest = std::max(furthest, pose.t.norm());
  rounding_ = 1e-15 * stiffest * furthest;
  searched_ = true;
}

double ContactWorld::value(const Poses& poses) const {
  double sum = contacts_.value(poses);
  for (const auto& energy : energies_) sum += energy->value(poses);
  return sum;
}

Motions ContactWorld::newton_step(const Motions& gradient) const {
  const Eigen::MatrixXd solved =
      hessian_->solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()));
  return Eigen::Map<const Motions>(solved.data(), gradient.rows(), 6);
}

double ContactWorld::given_gradient(const Poses& poses, Motions& out,
                                    BlockMatrix<6>* hessian) const {
  out.setZero(poses.size(), 6);
  double energy = 0;
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    energy += energies_[k]->derivatives(poses, options_.lever, out, hessian, first_[k]);
  }
  return energy;
}

void ContactWorld::hold_fixed(Motions& gradient) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed) gradient.row(i).setZero();
  }
}

double ContactWorld::force_unit(const Motions& given) const {
  double scale = 0;
  int free = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed) continue;
    scale += given.row(i).norm();
    ++free;
  }
  scale = std::max({scale / std::max(free, 1), contacts_.mean_push(poses_), options_.least_unit});
  return scale > 0 ? scale : 1;
}

Motions ContactWorld::given_forces() const {
  Motions out = Motions::Zero(poses_.size(), 6);
  for (const auto& energy : energies_) energy->derivatives(poses_, 1, out, nullptr, 0);
  return -out;
}

}  // namespace curveups
