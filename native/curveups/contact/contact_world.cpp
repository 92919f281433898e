// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/contact_world.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "curveups/core/sort_unique.hpp"

namespace curveups {

ContactWorld::ContactWorld(std::vector<RigidBody> bodies, Poses start, const WorldOptions& options)
    : bodies_(std::move(bodies)), poses_(std::move(start)), options_(options) {}

void ContactWorld::begin_path(const Pace& pace) {
  options_.pace = pace;
  contacts_.forget_corners();
  searched_ = false;
  weight_ = -1;
}

void ContactWorld::set_poses(const Poses& poses) {
  poses_ = poses;
  searched_ = false;
  weight_ = -1;
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
  hessian_ = std::make_unique<BlockMatrix<6>>(std::make_shared<const BlockPattern>(free, couplings),
                                              unknowns);
}

// Bodies that the energies join, and those around a point. The latter depend on one another once it
// is eliminated: their places in the pattern cost little, and the pattern need not change when they
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
  sort_unique(pairs);
  return pairs;
}

void ContactWorld::search() {
  contacts_.pairs = find_touching(bodies_, poses_, options_.pace.search, contacts_.pairs);
  // The pattern and its order of elimination stay as long as no new pair touches.
  if (!joined_) joined_ = joined_pairs();
  if (contacts_.couple_pairs(*joined_) || !hessian_) make_pattern();
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

// Drag between bodies that touch or are near, or that the energies join. Fixed bodies are left out:
// their middle may be far away.
Drag ContactWorld::make_drag() const {
  std::vector<std::array<int, 2>> near, all;
  for (const TouchingPair& pair : contacts_.pairs) near.push_back(pair.body);
  std::set_union(near.begin(), near.end(), joined_->begin(), joined_->end(),
                 std::back_inserter(all));
  std::vector<Drag::Pair> pairs;
  for (const auto& [a, b] : all) {
    if (bodies_[a].fixed || bodies_[b].fixed) continue;
    pairs.push_back({{a, b}, first_.back() + contacts_.coupling({a, b})});
  }
  return {pairs, poses_, options_.lever, options_.pace.lone_drag};
}

double ContactWorld::value(const Poses& poses) const {
  double sum = contacts_.value(poses);
  for (const auto& energy : energies_) sum += energy->value(poses);
  return sum;
}

// Derivatives of all but the drag, zero for fixed bodies.
double ContactWorld::derivatives(const Poses& poses, Motions& gradient, BlockMatrix<6>* hessian,
                                 bool projected) const {
  gradient.setZero(poses.size(), 6);
  MotionHessian second{hessian, first_.back(), projected};
  const MotionHessian* wanted = hessian ? &second : nullptr;
  double energy = contacts_.derivatives(poses, options_.lever, gradient, wanted);
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    second.first = first_[k];
    energy += energies_[k]->derivatives(poses, options_.lever, gradient, wanted);
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed) gradient.row(i).setZero();
  }
  return energy;
}

double ContactWorld::force_unit() const {
  Motions given = Motions::Zero(poses_.size(), 6);
  for (const auto& energy : energies_) {
    energy->derivatives(poses_, options_.lever, given, nullptr);
  }
  double sum = 0;
  int free = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed) continue;
    sum += given.row(i).norm();
    ++free;
  }
  const double unit =
      std::max({sum / std::max(free, 1), contacts_.mean_push(poses_), options_.least_unit});
  return unit > 0 ? unit : 1;
}

Motions ContactWorld::given_forces() const {
  Motions out = Motions::Zero(poses_.size(), 6);
  for (const auto& energy : energies_) energy->derivatives(poses_, 1, out, nullptr);
  return -out;
}

StepReport ContactWorld::settle(int max_steps, const std::function<bool(const StepReport&)>& done) {
  StepReport report;
  for (int k = 0; k < max_steps; ++k) {
    report = step();
    if (report.at_rest || (done && done(report))) break;
  }
  return report;
}

}  // namespace curveups
