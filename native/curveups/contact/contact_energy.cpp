// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/contact_energy.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// mm: points that are no farther than this from a face touch it where all that touches sticks.
constexpr double bond_gap = 0.02;

Vec3 seen(const Poses& poses, const TouchingPair& pair, const Touch& touch) {
  return seen_from(poses[pair.body[1 - touch.of]], poses[pair.body[touch.of]], touch.point);
}

// Adds first derivatives of direction . y, y the point as the other body sees it.
void add_along(const Poses& poses, const TouchingPair& pair, const Touch& touch,
               const Vec3& direction, double lever, MotionDerivatives<2>& out) {
  add_seen_point(poses, pair.body, touch.of, 1 - touch.of, touch.point, direction,
                 Eigen::Matrix3d::Zero(), lever, false, 0, out);
}

// visit(touch) of all points of pairs.
template <class Pairs, class Visit>
void each(Pairs& pairs, const Visit& visit) {
  for (auto& pair : pairs) {
    for (auto& touch : pair.touches) visit(touch);
  }
}

// visit(touch, y), with the point as the other body sees it.
template <class Pairs, class Visit>
void each_seen(Pairs& pairs, const Poses& poses, const Visit& visit) {
  for (auto& pair : pairs) {
    for (auto& touch : pair.touches) visit(touch, seen(poses, pair, touch));
  }
}

// The tangential spring's force along its stretch, at most `cap`.
double hold(const Touch& touch, double stretch, double cap) {
  return std::min(touch.tangent_stiffness * stretch, cap);
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

std::unique_ptr<MotionEnergy> ContactEnergy::part(const BodyPart& bodies) const {
  auto out = std::make_unique<ContactEnergy>();
  out->friction_coefficient = friction_coefficient;
  for (const TouchingPair& pair : pairs) {
    std::array<int, 2> body = pair.body;
    if (!bodies.take(body)) continue;
    out->pairs.push_back(pair);
    out->pairs.back().body = body;
    out->pairs.back().coupling = static_cast<int>(out->coupled.size());
    out->coupled.push_back(body);
  }
  return out;
}

void ContactEnergy::take_caps(const ContactEnergy& other, const BodyPart& bodies) {
  auto from = other.pairs.begin();
  for (TouchingPair& pair : pairs) {
    std::array<int, 2> body = pair.body;
    if (!bodies.take(body)) continue;
    for (std::size_t k = 0; k < pair.touches.size(); ++k) {
      pair.touches[k].cap = from->touches[k].cap;
    }
    ++from;
  }
}

void ContactEnergy::couple(std::vector<Coupling>& couplings) const {
  for (const std::array<int, 2>& pair : coupled) couplings.push_back({pair[0], pair[1]});
}

void ContactEnergy::add_pair(const TouchingPair& pair, const Poses& poses, double lever,
                             bool second, MotionDerivatives<2>& out) const {
  for (const Touch& touch : pair.touches) {
    const Vec3 y = seen(poses, pair, touch);
    const bool holds = glued && std::isinf(touch.cap);
    const double push = holds ? -touch.stiffness * touch.gap(y) : touch.push(y);
    const Vec2 u = touch.reach(y);
    const double length = u.norm(), k = touch.tangent_stiffness;
    const bool slips = k * length > touch.cap;
    if (push == 0 && touch.cap == 0) continue;
    out.value += 0.5 * push * push / touch.stiffness +
                 (slips ? touch.cap * (length - 0.5 * touch.cap / k) : 0.5 * k * length * length);
    if (lever <= 0) continue;  // the value is all that is asked for
    const Vec2 along = slips ? Vec2(u / length) : Vec2::Zero();
    const Vec2 tangential = slips ? Vec2(touch.cap * along) : Vec2(k * u);
    const Vec3 by_y = -push * touch.normal + touch.tangents * tangential;
    Eigen::Matrix3d by_y_twice = Eigen::Matrix3d::Zero();
    if (second) {
      if (push > 0 || holds) by_y_twice = touch.stiffness * touch.normal * touch.normal.transpose();
      Eigen::Matrix2d plane = k * Eigen::Matrix2d::Identity();
      if (slips) {
        plane *= touch.cap / (k * length);
        if (!careful) plane -= touch.cap / length * along * along.transpose();
      }
      by_y_twice += touch.tangents * plane * touch.tangents.transpose();
    }
    add_seen_point(poses, pair.body, touch.of, 1 - touch.of, touch.point, by_y, by_y_twice, lever,
                   second, convex, out);
  }
}

double ContactEnergy::value(const Poses& poses) const {
  return parallel_sum(static_cast<int>(pairs.size()), [&](int k) {
    MotionDerivatives<2> out;
    add_pair(pairs[k], poses, 0, false, out);
    return out.value;
  });
}

double ContactEnergy::derivatives(const Poses& poses, double lever, Motions& gradient,
                                  BlockMatrix<6>* hessian, int first) const {
  double sum = 0;
  parallel_gather<MotionDerivatives<2>>(
      static_cast<int>(pairs.size()),
      [&](int k, MotionDerivatives<2>& out) {
        out.clear(hessian != nullptr);
        add_pair(pairs[k], poses, lever, hessian != nullptr, out);
      },
      [&](int k, const MotionDerivatives<2>& out) {
        sum += out.value;
        out.add_to(pairs[k].body, gradient, hessian, first + pairs[k].coupling);
      });
  return sum;
}

Eigen::VectorXd ContactEnergy::cone_errors(const Poses& poses) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(poses.size()));
  if (is_bonded()) return out;
  for (const TouchingPair& pair : pairs) {
    double error = 0;
    for (const Touch& touch : pair.touches) {
      const Vec3 y = seen(poses, pair, touch);
      const double stretch = touch.reach(y).norm();
      error = std::max(error, std::abs(hold(touch, stretch, touch.cap) -
                                       hold(touch, stretch, friction_coefficient * touch.push(y))));
    }
    for (int body : pair.body) out(body) = std::max(out(body), error);
  }
  return out;
}

int ContactEnergy::touch_count() const {
  int count = 0;
  for (const TouchingPair& pair : pairs) count += static_cast<int>(pair.touches.size());
  return count;
}

Eigen::VectorXd ContactEnergy::caps() const {
  Eigen::VectorXd out(touch_count());
  int at = 0;
  each(pairs, [&](const Touch& touch) { out(at++) = touch.cap; });
  return out;
}

Eigen::VectorXd ContactEnergy::caps_at(const Poses& poses) const {
  Eigen::VectorXd out(touch_count());
  int at = 0;
  each_seen(pairs, poses, [&](const Touch& touch, const Vec3& y) {
    out(at++) = friction_coefficient * touch.push(y);
  });
  return out;
}

void ContactEnergy::set_caps(const Eigen::VectorXd& caps) {
  int at = 0;
  each(pairs, [&](Touch& touch) { touch.cap = std::max(0.0, caps(at++)); });
}

Eigen::VectorXd ContactEnergy::caps_after(const Poses& poses, double lever,
                                          const Motions& motions) const {
  Eigen::VectorXd out(touch_count());
  int at = 0;
  MotionDerivatives<2> gap;
  for (const TouchingPair& pair : pairs) {
    for (const Touch& touch : pair.touches) {
      double push = touch.push(seen(poses, pair, touch));
      if (push > 0) {
        gap.clear(false);
        add_along(poses, pair, touch, touch.normal, lever, gap);
        push -= touch.stiffness * (gap.gradient.head<6>().dot(motions.row(pair.body[0])) +
                                   gap.gradient.tail<6>().dot(motions.row(pair.body[1])));
      }
      out(at++) = friction_coefficient * std::max(0.0, push);
    }
  }
  return out;
}

void ContactEnergy::add_caps(const Poses& poses, double lever, const Eigen::VectorXd& caps,
                             Motions& gradient) const {
  int at = 0;
  MotionDerivatives<2> friction;
  for (const TouchingPair& pair : pairs) {
    for (const Touch& touch : pair.touches) {
      const double change = caps(at++) - touch.cap;
      if (change == 0) continue;
      const Vec2 reach = touch.reach(seen(poses, pair, touch));
      const double stretch = reach.norm();
      if (touch.tangent_stiffness * stretch <= touch.cap) continue;
      friction.clear(false);
      add_along(poses, pair, touch, touch.tangents * (change / stretch * reach), lever, friction);
      friction.add_to(pair.body, gradient, nullptr, 0);
    }
  }
}

void ContactEnergy::stick() {
  each(pairs, [](Touch& touch) { touch.cap = std::numeric_limits<double>::infinity(); });
}

void ContactEnergy::bond(const Poses& poses) {
  each_seen(pairs, poses, [](Touch& touch, const Vec3& y) {
    touch.cap = touch.gap(y) <= bond_gap ? std::numeric_limits<double>::infinity() : 0.0;
  });
}

void ContactEnergy::forget_corners() {
  each(pairs,
       [](Touch& touch) { touch.built.setConstant(std::numeric_limits<double>::infinity()); });
}

double ContactEnergy::friction_work(const Poses& poses) const {
  if (is_bonded()) return 0;
  double work = 0;
  each_seen(pairs, poses, [&](const Touch& touch, const Vec3& y) {
    const double stretch = touch.reach(y).norm(), limit = friction_coefficient * touch.push(y);
    const double held = hold(touch, stretch, limit);
    work += limit * (stretch - held / touch.tangent_stiffness);
  });
  return work;
}

void ContactEnergy::remember(const Poses& poses) {
  each_seen(pairs, poses, [&](Touch& touch, const Vec3& y) {
    const Vec2 reach = touch.reach(y);
    const double length = reach.norm();
    const double limit = is_bonded() ? touch.cap : friction_coefficient * touch.push(y);
    const double held = hold(touch, length, limit) / touch.tangent_stiffness;
    if (held < length) {
      // What a nearest point on a face that is touched otherwise remembered may be more than this
      // one can hold, where nothing moved.
      if (touch.push(y) > 0) {
        const Vec2 way = touch.tangents.transpose() * y - touch.reference;
        touch.slip += std::min(length - held, way.norm());
      }
      touch.stretch = held / length * reach;
    } else {
      touch.stretch = reach;
    }
    touch.reference = touch.tangents.transpose() * y;
  });
}

std::vector<TouchForce> ContactEnergy::forces(const Poses& poses) const {
  std::vector<TouchForce> out;
  out.reserve(touch_count());
  for (const TouchingPair& pair : pairs) {
    for (const Touch& touch : pair.touches) {
      const RigidMotion& other = poses[pair.body[1 - touch.of]];
      const Vec3 y = seen(poses, pair, touch);
      // By y the gradient is the force that the point exerts on the other body.
      const double sign = touch.of == 0 ? 1 : -1;
      TouchForce force{pair.body, poses[pair.body[touch.of]](touch.point),
                       -sign * (other.R * touch.normal), touch.push(y)};
      const Vec2 reach = touch.reach(y);
      const double length = reach.norm();
      if (length > 0) {
        force.friction =
            sign * hold(touch, length, touch.cap) / length * (other.R * (touch.tangents * reach));
      }
      force.gap = touch.gap(y);
      force.slip = touch.slip;
      out.push_back(force);
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
