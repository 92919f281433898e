// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/settling.hpp"

#include <algorithm>
#include <map>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

// Tiles that have not come to rest by then have no answer.
constexpr int most_steps = 60, most_iterations = 2000;
// How often elements are solved where tiles rest, and by how much they may then differ from what
// the tiles feel, over the mean force on a tile.
constexpr int most_rounds = 4;
constexpr double element_tolerance = 1e-3;
constexpr int most_named = 10;  // tiles that have drifted furthest

}  // namespace

double hold_tolerance(const Parameters& p) {
  return p.hold_tolerance > 0 ? p.hold_tolerance : 0.01 * p.L;
}

Settling::Settling(const TileBodies& bodies, const SolvedDesign& solved,
                   const std::array<double, 2>& pull)
    : tiles_(bodies.geometry.tiles),
      centres_(tile_centres(tiles_)),
      built_(make_tile_world(bodies, solved, pull)),
      hold_tolerance_(curveups::hold_tolerance(bodies.parameters)) {}

void Settling::settle(double friction, SolvedDesign* elements) {
  built_.world->set_friction(friction);
  at_rest_ = come_to_rest();
  for (int round = 0; elements && at_rest_ && round < most_rounds; ++round) {
    element_change_ = built_.solve_elements(*elements, element_tolerance);
    if (element_change_ <= element_tolerance) break;
    at_rest_ = come_to_rest();
  }
  drift_ = drifts().mean();
  measure_forces();
}

// Until the tiles are at rest, or are known not to hold.
bool Settling::come_to_rest() {
  const StepReport last = built_.world->settle(most_steps, [&](const StepReport& step) {
    iterations_ += step.iterations;
    factorizations_ += step.factorizations;
    checkpoint();
    return has_left() || iterations_ > most_iterations;
  });
  return last.at_rest;
}

// Tiles have moved by more than the tolerance in the mean, and the surface as well.
bool Settling::has_left() const {
  double moved = 0;
  for (int i = 0; i < tiles_.tile_count(); ++i) {
    moved += (built_.world->poses()[i].t - built_.world->stuck_poses()[i].t).norm();
  }
  return moved > hold_tolerance_ * tiles_.tile_count() && drifts().mean() > hold_tolerance_;
}

TriangleMesh Settling::surface_at(const Poses& poses) const {
  return fitted_surface(tiles_, centres_, poses);
}

// How far the surface is from where nothing had slipped yet, as scan_distances has it.
Eigen::VectorXd Settling::drifts() const {
  return scan_distances(surface(), ClosestPoints(surface_at(built_.world->stuck_poses())));
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
    const Eigen::VectorXd far = triangle_means(drifts());
    std::vector<std::pair<double, int>> worst;
    for (int i = 0; i < tiles_.tile_count(); ++i) {
      if (far(i) > hold_tolerance_) worst.push_back({-far(i), i});
    }
    std::sort(worst.begin(), worst.end());
    worst.resize(std::min<std::size_t>(worst.size(), most_named));
    Finding finding{"settled_drift", {}, {{"drift", drift_}, {"most", hold_tolerance_}}};
    for (const auto& [_, tile] : worst) finding.tiles.push_back(tile);
    std::sort(finding.tiles.begin(), finding.tiles.end());
    return finding;
  }
  if (!at_rest_) return Finding{"settled_restless"};
  const Finding::Pairs open = open_contacts();
  if (open.empty()) return std::nullopt;
  return Finding{"settled_open", tiles_of(open), {{"contacts", open}}};
}

}  // namespace curveups
