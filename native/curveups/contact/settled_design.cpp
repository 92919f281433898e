// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/settled_design.hpp"

#include <algorithm>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

// Tiles that have not come to rest by then have no answer.
constexpr int most_steps = 60, most_iterations = 2000;
// Rounds of solving elements where tiles rest, and the element_change that ends them.
constexpr int most_rounds = 4;
constexpr double element_tolerance = 1e-3;
constexpr int most_named = 10;  // tiles that have drifted furthest

// Drift of the shape that friction may allow, mm.
double hold_tolerance(const Parameters& p) {
  return p.hold_tolerance > 0 ? p.hold_tolerance : 0.01 * p.L;
}

class Settling {
 public:
  Settling(TileWorld& tiles, const TileBodies& bodies)
      : tiles_(bodies.geometry.tiles),
        centres_(tile_centres(tiles_)),
        world_(*tiles.world),
        tolerance_(hold_tolerance(bodies.parameters)) {}

  // Returns whether the tiles are at rest; ends early where they are known not to hold.
  bool come_to_rest() {
    return world_
        .settle(most_steps,
                [&](const StepReport& step) {
                  iterations_ += step.iterations;
                  checkpoint();
                  return has_left() || iterations_ > most_iterations;
                })
        .at_rest;
  }
  // Fills in all but element_change.
  void describe(SettledTiles& out) const;

 private:
  // Distances of the surface from where nothing had slipped yet, as scan_distances has them.
  Eigen::VectorXd drifts() const {
    return scan_distances(fitted_surface(tiles_, centres_, world_.poses()),
                          ClosestPoints(fitted_surface(tiles_, centres_, world_.stuck_poses())));
  }
  // Tiles have moved by more than the tolerance in the mean, and the surface as well.
  bool has_left() const {
    double moved = 0;
    for (int i = 0; i < tiles_.tile_count(); ++i) {
      moved += (world_.poses()[i].t - world_.stuck_poses()[i].t).norm();
    }
    return moved > tolerance_ * tiles_.tile_count() && drifts().mean() > tolerance_;
  }
  Finding drift_finding(double drift, const Eigen::VectorXd& of_tiles) const;

  const TileMesh& tiles_;
  Points3 centres_;
  ContactWorld& world_;
  double tolerance_;
  int iterations_ = 0;
};

Finding Settling::drift_finding(double drift, const Eigen::VectorXd& of_tiles) const {
  std::vector<std::pair<double, int>> worst;
  for (int i = 0; i < tiles_.tile_count(); ++i) {
    if (of_tiles(i) > tolerance_) worst.push_back({-of_tiles(i), i});
  }
  std::sort(worst.begin(), worst.end());
  worst.resize(std::min<std::size_t>(worst.size(), most_named));
  Finding finding{"settled_drift", {}, {{"drift", drift}, {"most", tolerance_}}};
  for (const auto& [_, tile] : worst) finding.tiles.push_back(tile);
  std::sort(finding.tiles.begin(), finding.tiles.end());
  return finding;
}

void Settling::describe(SettledTiles& out) const {
  out.contact_force = contact_pushes(tiles_, world_);
  for (Eigen::Index k = 0; k < out.contact_force.size(); ++k) {
    if (out.contact_force(k) == 0) out.open_contacts.push_back(tiles_.contacts[k].tile);
  }
  const Eigen::VectorXd far = drifts();
  out.drift = far.mean();
  out.iterations = iterations_;
  if (out.drift > tolerance_) {
    out.failure = drift_finding(out.drift, triangle_means(far));
  } else if (!out.converged) {
    out.failure = Finding{"settled_restless"};
    return;
  } else if (const Finding::Pairs open = out.open_contacts; !open.empty()) {
    out.failure = Finding{"settled_open", tiles_of(open), {{"contacts", open}}};
  }
  out.holds = !out.failure;
}

}  // namespace

SettledTiles settle_tiles(TileWorld& tiles, const TileBodies& bodies, double friction,
                          SolvedDesign* elements) {
  Settling settling(tiles, bodies);
  tiles.world->set_friction(friction);
  SettledTiles out;
  out.converged = settling.come_to_rest();
  for (int round = 0; elements && out.converged && round < most_rounds; ++round) {
    out.element_change = tiles.solve_elements(*elements, element_tolerance);
    if (out.element_change <= element_tolerance) break;
    out.converged = settling.come_to_rest();
  }
  settling.describe(out);
  return out;
}

SettledDesign settle_design(const Design& design, const Progress& progress,
                            const SolvedHandle& solved_before) {
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  SolvedDesign solved =
      solved_before ? *solved_before : solve_design(bodies.geometry, design, progress);
  solved.design = design;
  checkpoint("settle", 0);
  SettledDesign out;
  out.margin = find_margin(solved, bodies.geometry, progress);
  out.friction_needed = find_friction_needed(solved, bodies.geometry, progress);
  const WindowSample sample = [&](const std::array<double, 2>& pull, double friction) {
    TileWorld tiles = make_tile_world(bodies, solved, pull);
    return settle_tiles(tiles, bodies, friction).failure;
  };
  const double mu = out.friction_coefficient = design.parameters.friction_coefficient;
  out.hold_tolerance = hold_tolerance(design.parameters);
  // Before the elements of `solved` move along with the tiles.
  if (design.parameters.window && !sample({1, 1}, mu)) out.window = process_window(mu, sample);
  TileWorld tiles = make_tile_world(bodies, solved);
  static_cast<SettledTiles&>(out) = settle_tiles(tiles, bodies, mu, &solved);
  if (!out.holds.value_or(false)) out.window.clear();
  if (!out.window.empty()) out.holding_friction = out.window.back().end[0].value;

  if (out.contact_force.size() > 0) {
    out.normal_mean = out.contact_force.mean();
    out.normal_min = out.contact_force.minCoeff();
  }
  for (const TouchForce& force : tiles.world->forces()) {
    if (force.push > 0) out.largest_slip = std::max(out.largest_slip, force.slip);
  }
  const TileMesh& mesh = bodies.geometry.tiles;
  const TriangleMesh scanned = fitted_surface(mesh, tile_centres(mesh), tiles.world->poses());
  const Eigen::VectorXd far = scan_distances(scanned, ClosestPoints(design.mesh));
  out.scan = describe_scan(far, scanned, design.mesh);
  out.deviation = triangle_means(far);
  return out;
}

}  // namespace curveups
