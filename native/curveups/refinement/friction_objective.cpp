// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/friction_objective.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/bodies/bumps.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/physics/verification.hpp"
#include "curveups/refinement/force_rows.hpp"

namespace curveups {
namespace {

constexpr double normal_weight = 1e-3;  // e
constexpr double floor_of_mean = 0.15;  // over the mean normal force; f_min is a tenth by default
constexpr int most_rounds = 12;         // of the active set

// Tiles that share a vertex with each, itself among them; ascending.
std::vector<std::vector<int>> tiles_around(const TileMesh& tiles) {
  const std::vector<std::vector<int>> at = tiles_at_vertices(tiles);
  std::vector<std::vector<int>> out(tiles.tile_count());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int v : tiles.mesh.F.row(i)) out[i].insert(out[i].end(), at[v].begin(), at[v].end());
    sort_unique(out[i]);
  }
  return out;
}

// Colouring of the tiles: no tile is around two of a colour.
std::vector<std::vector<int>> coloured(const std::vector<std::vector<int>>& around) {
  std::vector<int> colour(around.size(), -1);
  std::vector<std::vector<int>> out;
  for (std::size_t i = 0; i < around.size(); ++i) {
    std::vector<char> taken(out.size() + 1, 0);
    for (int k : around[i]) {
      for (int j : around[k]) {
        if (colour[j] >= 0) taken[colour[j]] = 1;
      }
    }
    colour[i] = static_cast<int>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    if (colour[i] == static_cast<int>(out.size())) out.emplace_back();
    out[colour[i]].push_back(static_cast<int>(i));
  }
  return out;
}

}  // namespace

FrictionObjective::FrictionObjective(const DesignGeometry& geometry, const Parameters& parameters,
                                     const FlatPoses& poses, const Wrenches& loads, double unit)
    : system_(make_balance_system(
          geometry, parameters,
          points_at_tips(contact_corners(geometry, parameters),
                         bump_tips(plan_bumps(geometry, poses, parameters), geometry.tiles)))),
      unit_(unit) {
  find_forces(loads);
}

// Finds the active set of floors; leaves the system factorized for it.
void FrictionObjective::find_forces(const Wrenches& loads) {
  const int count = system_.point_count();
  const double floor = floor_of_mean * unit_;
  const Eigen::VectorXd b = system_.restrict(loads);
  std::vector<char> active(count, 0);
  bool changed = true;
  for (int round = 0; changed && round < most_rounds; ++round) {
    std::vector<Eigen::Matrix3d> inverse(count);  // D^-1
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(3 * count);
    for (int p = 0; p < count; ++p) {
      const double weight = active[p] ? normal_weight + 1 : normal_weight;
      inverse[p] = Vec3(1 / weight, 1, 1).asDiagonal();
      if (active[p]) wanted(3 * p) = floor / weight;
    }
    if (!system_.factorize(inverse)) throw no_balance();
    right_ = b + system_.apply(wanted);
    const Eigen::VectorXd pull = system_.apply_transposed(system_.solve(right_));
    force_.resize(count, 3);
    value_ = 0;
    changed = false;
    for (int p = 0; p < count; ++p) {
      const Vec3 f = wanted.segment<3>(3 * p) - inverse[p] * pull.segment<3>(3 * p);
      const double lacking = std::max(0.0, floor - f.x());
      force_.row(p) = f.transpose();
      value_ += 0.5 *
                (f.tail<2>().squaredNorm() + normal_weight * f.x() * f.x() + lacking * lacking) /
                (unit_ * unit_);
      changed = changed || (f.x() < floor) != active[p];
      active[p] = f.x() < floor;
    }
  }
}

double FrictionObjective::tangential() const {
  return std::sqrt(force_.rightCols<2>().squaredNorm() /
                   std::max<double>(1, static_cast<double>(force_.rows()))) /
         unit_;
}

StepObjective FrictionObjective::linearise(const Iterate& place, const DesignForces& forces) const {
  return {jacobian(place, forces), right_, [this](const Eigen::VectorXd& v) {
            return Eigen::VectorXd(system_.solve(v) / (unit_ * unit_));
          }};
}

// A tile's wrench depends on the tiles around it, as pins fix the membrane between others. One
// back-solve a component of the wrench therefore serves all tiles of a colour.
SparseRows FrictionObjective::jacobian(const Iterate& place, const DesignForces& forces) const {
  const int count = place.geometry().tiles.tile_count();
  const std::vector<std::vector<int>> around = tiles_around(place.geometry().tiles);
  std::vector<Eigen::Triplet<double>> entries;
  for (const std::vector<int>& tiles : coloured(around)) {
    std::vector<Array6> motions(6, Array6::Zero(count, 6));
    for (int c = 0; c < 6; ++c) {
      for (int i : tiles) motions[c](i, c) = 1;
    }
    const std::vector<ForceGradient> gradients = load_gradients(forces, motions);
    for (int c = 0; c < 6; ++c) {
      const ForceRow row = make_force_row(place, 0, -1, gradients[c], nullptr);
      for (int i : tiles) {
        if (!system_.has_rows(i)) continue;
        for (int k : around[i]) {
          for (int u = 0; u < unknowns_per_tile; ++u) {
            entries.emplace_back(system_.first_row(i) + c, unknowns_per_tile * k + u,
                                 row.gradient(k, u));
          }
        }
      }
    }
  }
  SparseRows out(system_.rows(), unknowns_per_tile * count);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace curveups
