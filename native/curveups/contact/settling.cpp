// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/settling.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

// What has not come to rest by then has no answer.
constexpr int most_steps = 60, most_iterations = 2000;
// How often elements are solved where tiles rest under Coulomb's law, and by how much they may then
// differ from what the tiles feel, over the mean force on a tile.
constexpr int most_rounds = 4;
constexpr double element_tolerance = 1e-3;
// Forces left and friction beyond its cone, over the mean normal force. At the corners of a margin
// drifts were off by up to 0.07 mm with 1e-3, by up to 0.003 with this, where 0.07 is allowed. As
// long as tiles move, their outlines are clipped anew from step to step, so that only the last rest
// of the design as it stands is worth WorldOptions'.
constexpr double sample_tolerance = 1e-4, sample_cone_tolerance = 1e-4, sample_cone_share = 0.3;

}  // namespace

double hold_tolerance(const Parameters& p) {
  return p.hold_tolerance > 0 ? p.hold_tolerance : 0.01 * p.L;
}

Settling::Settling(const Design& design, const TileBodies& bodies, const SolvedDesign& solved)
    : tiles_(bodies.geometry.tiles),
      centres_(tile_centres(tiles_)),
      built_(make_tile_world(bodies, solved, design.parameters.tile_modulus)),
      hold_tolerance_(curveups::hold_tolerance(design.parameters)) {
  built_.world->set_tolerances(sample_tolerance, sample_cone_tolerance, sample_cone_share);
}

Settling::Settling(const Settling& other)
    : tiles_(other.tiles_),
      centres_(other.centres_),
      built_(other.built_.copy()),
      hold_tolerance_(other.hold_tolerance_),
      element_change_(other.element_change_) {
  restore(other.state());
}

void Settling::settle(const Conditions& conditions, double friction, SolvedDesign* elements) {
  ContactWorld& world = *built_.world;
  bool still = true;
  if (!compressed_ || !(conditions == built_.conditions)) {
    drift_before_ = drift_;
    compressed_.reset();
    built_.set(conditions);
    world.set_friction(std::numeric_limits<double>::infinity());
    still = come_to_rest(elements);
    compressed_ = std::make_shared<ClosestPoints>(surface());
  }
  friction_ = friction;
  world.set_friction(friction);
  at_rest_ = come_to_rest(elements) && still;
  if (elements && at_rest_) {
    const WorldOptions last;
    world.set_tolerances(last.tolerance, last.cone_tolerance, last.cone_share);
    at_rest_ = come_to_rest();
    world.set_tolerances(sample_tolerance, sample_cone_tolerance, sample_cone_share);
  }
  drift_ = measured_drift();
  measure_forces();
}

// Until the tiles are at rest, under what elements pull there, or are known not to hold. Where all
// sticks elements are solved once: friction's rest has the last word.
bool Settling::come_to_rest(SolvedDesign* elements) {
  int iterations = 0;
  const int rounds = elements ? (compressed_ ? most_rounds : 1) : 0;
  for (int round = 0;; ++round) {
    const StepReport last = built_.world->settle(most_steps, [&](const StepReport& step) {
      iterations += step.iterations;
      iterations_ += step.iterations;
      factorizations_ += step.factorizations;
      checkpoint();
      return has_left() || iterations > most_iterations;
    });
    if (!last.at_rest || round == rounds) return last.at_rest;
    element_change_ = built_.solve_elements(*elements, element_tolerance);
    if (element_change_ <= element_tolerance) return true;
  }
}

// Tiles have moved by more than the tolerance in the mean, and the surface as well.
bool Settling::has_left() const {
  if (!compressed_) return false;
  double moved = 0;
  for (int i = 0; i < tiles_.tile_count(); ++i) {
    moved += (built_.world->poses()[i].t - centres_.row(i).transpose()).norm();
  }
  return moved > hold_tolerance_ * tiles_.tile_count() && measured_drift() > hold_tolerance_;
}

TriangleMesh Settling::surface() const {
  return fitted_surface(tiles_, centres_, built_.world->poses());
}

double Settling::measured_drift() const {
  return drift_before_ + scan_distances(surface(), *compressed_).mean();
}

void Settling::measure_forces() {
  std::map<std::array<int, 2>, int> contact_of;
  for (std::size_t k = 0; k < tiles_.contacts.size(); ++k) {
    contact_of[tiles_.contacts[k].tile] = static_cast<int>(k);
  }
  contact_force_.setZero(tiles_.contacts.size());
  for (const TouchForce& force : built_.world->forces()) {
    const auto contact = contact_of.find(force.body);
    if (contact != contact_of.end()) contact_force_(contact->second) += force.push;
  }
}

std::vector<std::array<int, 2>> Settling::open_contacts() const {
  std::vector<std::array<int, 2>> open;
  for (Eigen::Index k = 0; k < contact_force_.size(); ++k) {
    if (contact_force_(k) == 0) open.push_back(tiles_.contacts[k].tile);
  }
  return open;
}

std::optional<Finding> Settling::failure() const {
  if (drift_ > hold_tolerance_) {
    // The tiles that have gone furthest since conditions changed last: those beyond the tolerance
    // or, where earlier changes made most of the drift, any.
    const Eigen::VectorXd far = triangle_means(scan_distances(surface(), *compressed_));
    std::vector<std::pair<double, int>> worst;
    const double least = far.maxCoeff() > hold_tolerance_ ? hold_tolerance_ : 0;
    for (int i = 0; i < tiles_.tile_count(); ++i) {
      if (far(i) > least) worst.push_back({-far(i), i});
    }
    std::sort(worst.begin(), worst.end());
    worst.resize(std::min<std::size_t>(worst.size(), 10));
    Finding found{"settled_drift", {}, {{"drift", drift_}, {"most", hold_tolerance_}}};
    for (const auto& [_, tile] : worst) found.tiles.push_back(tile);
    std::sort(found.tiles.begin(), found.tiles.end());
    return found;
  }
  if (!at_rest_) return Finding{"settled_restless"};
  const Finding::Pairs open = open_contacts();
  if (open.empty()) return std::nullopt;
  return Finding{"settled_open", tiles_of(open), {{"contacts", open}}};
}

Settling::State Settling::state() const {
  return {built_.world->state(), built_.conditions, friction_,      drift_,
          drift_before_,         at_rest_,          contact_force_, compressed_};
}

void Settling::restore(const State& state) {
  built_.set(state.conditions);
  built_.world->restore(state.world);
  built_.world->set_friction(state.friction);
  friction_ = state.friction;
  drift_ = state.drift;
  drift_before_ = state.drift_before;
  at_rest_ = state.at_rest;
  contact_force_ = state.contact_force;
  compressed_ = state.compressed;
}

}  // namespace curveups
