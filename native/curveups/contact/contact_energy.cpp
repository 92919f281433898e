// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/contact_energy.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

constexpr double touching_gap = 0.02;  // mm: points nearer to a face than this touch it
// mm: points nearer than this are as stiff as those that push, so that they count in Newton's first
// step from where bodies just touch.
constexpr double grazing_gap = 1e-6;

// The touch's point in the coordinates of the other body.
Vec3 seen(const Poses& poses, const TouchingPair& pair, const Touch& touch) {
  return seen_from(poses[pair.body[1 - touch.of]], poses[pair.body[touch.of]], touch.point);
}

// Calls visit(touch, y) with y = seen.
template <class Pairs, class Visit>
void each_seen(Pairs& pairs, const Poses& poses, const Visit& visit) {
  for (auto& pair : pairs) {
    for (auto& touch : pair.touches) visit(touch, seen(poses, pair, touch));
  }
}

// Friction potential (Huber) of a tangential spring with a capped force at this stretch, and its
// derivative.
double friction_potential(const Touch& touch, double stretch) {
  const double k = touch.tangent_stiffness, c = touch.cap;
  return k * stretch <= c ? 0.5 * k * stretch * stretch : c * (stretch - 0.5 * c / k);
}
double friction_force(const Touch& touch, double stretch) {
  return std::min(touch.tangent_stiffness * stretch, touch.cap);
}
// Stretch that the spring keeps once it has slipped.
double kept_stretch(const Touch& touch, double stretch) {
  return friction_force(touch, stretch) / touch.tangent_stiffness;
}

}  // namespace

bool ContactEnergy::couple_pairs(const std::vector<std::array<int, 2>>& others) {
  std::vector<std::array<int, 2>> touching, all;
  for (const TouchingPair& pair : pairs) touching.push_back(pair.body);
  std::set_union(touching.begin(), touching.end(), others.begin(), others.end(),
                 std::back_inserter(all));
  const bool news = !std::includes(coupled.begin(), coupled.end(), all.begin(), all.end());
  if (news) {
    const std::vector<std::array<int, 2>> before = std::move(coupled);
    coupled.clear();
    std::set_union(before.begin(), before.end(), all.begin(), all.end(),
                   std::back_inserter(coupled));
  }
  for (TouchingPair& pair : pairs) pair.coupling = coupling(pair.body);
  return news;
}

int ContactEnergy::coupling(const std::array<int, 2>& pair) const {
  return static_cast<int>(std::lower_bound(coupled.begin(), coupled.end(), pair) - coupled.begin());
}

void ContactEnergy::couple(std::vector<Coupling>& couplings) const {
  for (const std::array<int, 2>& pair : coupled) couplings.push_back({pair[0], pair[1]});
}

// Adds the value alone where lever <= 0.
void ContactEnergy::add_pair(const TouchingPair& pair, const Poses& poses, double lever,
                             const MotionHessian* hessian, MotionDerivatives<2>& out) const {
  for (const Touch& touch : pair.touches) {
    const Vec3 y = seen(poses, pair, touch);
    const double push = touch.push(y), k = touch.tangent_stiffness;
    if (touch.gap(y) > grazing_gap && touch.cap == 0) continue;
    const Vec2 u = touch.reach(y);
    const double stretch = u.norm();
    out.value += 0.5 * push * push / touch.stiffness + friction_potential(touch, stretch);
    if (lever <= 0) continue;
    const double force = friction_force(touch, stretch);
    const bool slips = k * stretch > touch.cap;
    const Vec2 along = slips ? Vec2(u / stretch) : Vec2::Zero();
    const Vec3 by_y =
        -push * touch.normal + touch.tangents * (slips ? Vec2(force * along) : Vec2(k * u));
    Eigen::Matrix3d by_y_twice = Eigen::Matrix3d::Zero();
    if (hessian) {
      if (touch.gap(y) <= grazing_gap)
        by_y_twice = touch.stiffness * touch.normal * touch.normal.transpose();
      Eigen::Matrix2d plane = k * Eigen::Matrix2d::Identity();
      if (slips)
        plane = force / stretch * (Eigen::Matrix2d::Identity() - along * along.transpose());
      by_y_twice += touch.tangents * plane * touch.tangents.transpose();
    }
    add_seen_point(poses, pair.body, touch.of, 1 - touch.of, touch.point, by_y, by_y_twice, lever,
                   hessian, out);
  }
}

double ContactEnergy::value(const Poses& poses) const {
  return parallel_sum(static_cast<int>(pairs.size()), [&](int k) {
    MotionDerivatives<2> out;
    add_pair(pairs[k], poses, 0, nullptr, out);
    return out.value;
  });
}

double ContactEnergy::derivatives(const Poses& poses, double lever, Motions& gradient,
                                  const MotionHessian* hessian) const {
  double sum = 0;
  parallel_gather<MotionDerivatives<2>>(
      static_cast<int>(pairs.size()),
      [&](int k, MotionDerivatives<2>& out) {
        out.clear(hessian != nullptr);
        add_pair(pairs[k], poses, lever, hessian, out);
      },
      [&](int k, const MotionDerivatives<2>& out) {
        sum += out.value;
        out.add_to(pairs[k].body, gradient, hessian, pairs[k].coupling);
      });
  return sum;
}

void ContactEnergy::lag_friction(const Poses& poses) {
  each_seen(pairs, poses,
            [&](Touch& touch, const Vec3& y) { touch.cap = friction_coefficient * touch.push(y); });
}

void ContactEnergy::stick(const Poses& poses) {
  each_seen(pairs, poses, [](Touch& touch, const Vec3& y) {
    touch.cap = touch.gap(y) <= touching_gap ? std::numeric_limits<double>::infinity() : 0.0;
  });
}

void ContactEnergy::forget_corners() {
  for (TouchingPair& pair : pairs) {
    for (Touch& touch : pair.touches) {
      touch.built.setConstant(std::numeric_limits<double>::infinity());
    }
  }
}

double ContactEnergy::friction_work(const Poses& poses) const {
  double work = 0;
  each_seen(pairs, poses, [&](const Touch& touch, const Vec3& y) {
    const double stretch = touch.reach(y).norm(), slip = stretch - kept_stretch(touch, stretch);
    if (slip > 0) work += touch.cap * slip;
  });
  return work;
}

void ContactEnergy::remember(const Poses& poses) {
  each_seen(pairs, poses, [&](Touch& touch, const Vec3& y) {
    const Vec2 reach = touch.reach(y);
    const double length = reach.norm(), kept = kept_stretch(touch, length);
    if (kept < length) {
      // A history inherited from another contact point may exceed this point's cap: the excess is
      // no slip.
      if (touch.push(y) > 0) {
        const Vec2 way = touch.tangents.transpose() * y - touch.reference;
        touch.slip += std::min(length - kept, way.norm());
      }
      touch.stretch = kept / length * reach;
    } else {
      touch.stretch = reach;
    }
    touch.reference = touch.tangents.transpose() * y;
  });
}

std::vector<TouchForce> ContactEnergy::forces(const Poses& poses) const {
  std::vector<TouchForce> out;
  for (const TouchingPair& pair : pairs) {
    for (const Touch& touch : pair.touches) {
      out.push_back({pair.body, touch.push(seen(poses, pair, touch)), touch.slip});
    }
  }
  return out;
}

double ContactEnergy::mean_push(const Poses& poses) const {
  double sum = 0;
  int count = 0;
  each_seen(pairs, poses, [&](const Touch& touch, const Vec3& y) {
    const double push = touch.push(y);
    sum += push;
    count += push > 0;
  });
  return count > 0 ? sum / count : 0;
}

}  // namespace curveups
