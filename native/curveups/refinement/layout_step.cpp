// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/layout_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

constexpr int per_tile = unknowns_per_tile;

std::vector<int> with_neighbours(const LayoutModel& model, std::vector<char> chosen) {
  const std::vector<char> before = chosen;
  for (const CornerGap& gap : model.gaps) {
    if (before[gap.tile]) chosen[gap.other] = 1;
    if (before[gap.other]) chosen[gap.tile] = 1;
  }
  std::vector<int> tiles;
  for (int i = 0; i < model.tile_count(); ++i) {
    if (chosen[i]) tiles.push_back(i);
  }
  return tiles;
}

// Where a row of the step problem comes from.
struct RowSource {
  const char* what;
  std::array<int, 2> tiles;
};

}  // namespace

double angle_lever(const LayoutModel& model) { return model.L / std::sqrt(3.0); }

std::vector<int> tiles_that_matter(const LayoutModel& model, const std::vector<ForceRow>& rows,
                                   double share) {
  std::vector<char> chosen(model.tile_count(), 0);
  for (const ForceRow& row : rows) {
    const Eigen::VectorXd strength = row.gradient.rowwise().norm();
    const double least = share * strength.maxCoeff();
    for (int i = 0; i < model.tile_count(); ++i) {
      if (strength(i) >= least) chosen[i] = 1;
    }
  }
  return with_neighbours(model, std::move(chosen));
}

LayoutStep least_layout_step(const LayoutModel& model, const LayoutState& state,
                             const std::vector<ForceRow>& rows, const std::vector<int>& tiles,
                             const MovingVertices* vertices, const StepPrices& prices) {
  std::vector<int> slot(model.tile_count(), -1);
  for (std::size_t k = 0; k < tiles.size(); ++k) slot[tiles[k]] = static_cast<int>(k);
  const int own = static_cast<int>(tiles.size()) * per_tile;
  const int count = own + (vertices ? 3 * vertices->count() : 0);
  const double ease = std::sqrt(prices.layout);
  // Unknowns per unit of the step, which costs half its square.
  Eigen::Matrix<double, 1, per_tile> scale;
  scale.setConstant(1 / ease);
  scale(2) /= angle_lever(model);
  Eigen::VectorXd vertex_scale(vertices ? vertices->count() : 0);
  for (int v = 0; v < vertex_scale.size(); ++v) {
    vertex_scale(v) = 1 / std::sqrt(prices.target * vertices->weight(v));
  }

  LeastStepProblem problem;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> values;
  std::vector<RowSource> sources;
  std::vector<ConstraintRow> origin;
  const LayoutTerms constraints = make_constraints(model);
  LayoutTerm::Value value;
  for (std::size_t f = 0; f < constraints.size(); ++f) {
    const LayoutTerm& constraint = *constraints[f];
    for (int b = 0; b < constraint.element_count(); ++b) {
      const std::array<int, 2> ends = constraint.blocks(b);
      const bool first = slot[ends[0]] >= 0, second = ends[1] >= 0 && slot[ends[1]] >= 0;
      if (!first && !second) continue;
      constraint.at(b, state, true, value);
      double most = vertices ? 6 * prices.reach : 0;  // by which this step can lower it
      for (int end = 0; end < 2; ++end) {
        if (!(end == 0 ? first : second)) continue;
        most +=
            value.jacobian[end].row(0).cwiseProduct(scale).cwiseAbs().sum() * ease * prices.reach;
      }
      if (value.value(0) > most) continue;
      for (int end = 0; end < 2; ++end) {
        if (!(end == 0 ? first : second)) continue;
        for (int k = 0; k < per_tile; ++k) {
          const double entry = value.jacobian[end](0, k) * scale(k);
          if (entry != 0) {
            entries.emplace_back(static_cast<int>(values.size()), slot[ends[end]] * per_tile + k,
                                 entry);
          }
        }
      }
      values.push_back(value.value(0));
      sources.push_back({constraint.name().data(), ends});
      origin.push_back({static_cast<int>(f), b});
    }
  }
  if (vertices) {
    for (const VertexEntry& entry : rows_by_vertex(model, state, origin, *vertices)) {
      for (int c = 0; c < 3; ++c) {
        entries.emplace_back(entry.row, own + 3 * entry.vertex + c,
                             entry.derivative(c) * vertex_scale(entry.vertex));
      }
    }
  }
  problem.sparse.resize(static_cast<Eigen::Index>(values.size()), count);
  problem.sparse.setFromTriplets(entries.begin(), entries.end());
  problem.sparse_value =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  problem.dense.resize(count, static_cast<Eigen::Index>(rows.size()));
  problem.dense_value.resize(static_cast<Eigen::Index>(rows.size()));
  if (prices.stiffness > 0) {
    problem.dense_stiffness = prices.stiffness;
    problem.dense_price = 0;
  }
  const double reach = ease * prices.reach;  // in units of the step
  problem.lower = Eigen::VectorXd::Constant(count, -reach);
  problem.upper = Eigen::VectorXd::Constant(count, reach);
  problem.wanted = Eigen::VectorXd::Zero(count);
  const PinBounds& bounds = model.geometry->pin_bounds;
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    const int i = tiles[k], first = static_cast<int>(k) * per_tile;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      problem.dense.block<per_tile, 1>(first, static_cast<Eigen::Index>(r)) =
          rows[r].gradient.row(i).cwiseProduct(scale).transpose();
    }
    for (int t = 0; t < 6; ++t) {
      double& low = problem.lower(first + 3 + t);
      double& high = problem.upper(first + 3 + t);
      low = std::max(low, ease * (bounds.lower(i, t) - state(i, 3 + t)));
      high = std::min(high, ease * (bounds.upper(i, t) - state(i, 3 + t)));
    }
  }
  for (int v = 0; vertices && v < vertices->count(); ++v) {
    for (int c = 0; c < 3; ++c) {
      const int at = own + 3 * v + c;
      const double moved = vertices->moved(v, c), unit = vertex_scale(v);
      problem.lower(at) = std::min(0.0, std::max(-prices.reach, -prices.farthest - moved)) / unit;
      problem.upper(at) = std::max(0.0, std::min(prices.reach, prices.farthest - moved)) / unit;
      problem.wanted(at) = -moved / unit;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        problem.dense(at, static_cast<Eigen::Index>(r)) = rows[r].by_vertex(v, c) * unit;
      }
    }
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    problem.dense_value(static_cast<Eigen::Index>(r)) = rows[r].value;
  }

  const LeastStep least = solve_least_step(problem);
  LayoutStep out;
  out.step = LayoutState::Zero(state.rows(), per_tile);
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    out.step.row(tiles[k]) = least.z.segment<per_tile>(static_cast<Eigen::Index>(k) * per_tile)
                                 .transpose()
                                 .cwiseProduct(scale);
  }
  out.vertex_step.resize(vertex_scale.size(), 3);
  for (int v = 0; v < vertex_scale.size(); ++v) {
    out.vertex_step.row(v) = vertex_scale(v) * least.z.segment<3>(own + 3 * v).transpose();
  }
  out.unmet.assign(rows.size(), 0);
  for (Eigen::Index r = 0; prices.stiffness == 0 && r < least.dense_multiplier.size(); ++r) {
    out.unmet[r] = least.dense_multiplier(r) > 0.5 * problem.dense_price;
  }
  std::map<std::pair<std::vector<int>, std::string>, double> strength;
  for (std::size_t r = 0; r < sources.size(); ++r) {
    std::vector<int> ends = {sources[r].tiles[0]};
    if (sources[r].tiles[1] >= 0) ends.push_back(sources[r].tiles[1]);
    std::sort(ends.begin(), ends.end());
    strength[{ends, sources[r].what}] += least.sparse_multiplier(static_cast<Eigen::Index>(r));
  }
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    for (int t = 0; t < 6; ++t) {
      const Eigen::Index z = static_cast<Eigen::Index>(k) * per_tile + 3 + t;
      // Only where the inset itself, not the step's reach, is the limit.
      const double held = (problem.lower(z) > -reach ? least.lower_multiplier(z) : 0.0) +
                          (problem.upper(z) < reach ? least.upper_multiplier(z) : 0.0);
      strength[{{tiles[k]}, "inset at its limit"}] += held;
    }
  }
  for (const auto& [key, multiplier] : strength) {
    if (multiplier > 1e-3) out.obstacles.push_back({key.second, key.first, multiplier});
  }
  std::stable_sort(
      out.obstacles.begin(), out.obstacles.end(),
      [](const Obstacle& a, const Obstacle& b) { return a.multiplier > b.multiplier; });
  if (out.obstacles.size() > 8) out.obstacles.resize(8);
  return out;
}

double largest_violation(const LayoutModel& model, const LayoutState& state) {
  return largest_violation(make_constraints(model), state);
}

bool restore_constraints(LayoutModel& model, LayoutState& state, int most_steps) {
  constexpr double accuracy = 0.5 * tolerance::constraint;
  const double clearance = model.parameters.d_gap_min - accuracy;
  LayoutTerm::Value value;
  for (int step = 0; step <= most_steps; ++step) {
    std::vector<char> chosen(model.tile_count(), 0);
    double worst = 0;
    for (const auto& constraint : make_constraints(model)) {
      for (int b = 0; b < constraint->element_count(); ++b) {
        constraint->at(b, state, false, value);
        if (value.value(0) >= -accuracy) continue;
        const auto [i, j] = constraint->blocks(b);
        worst = std::max(worst, -value.value(0));
        chosen[i] = 1;
        if (j >= 0) chosen[j] = 1;
      }
    }
    if (worst == 0) {
      const std::vector<Separation> close =
          find_close_pairs(model.geometry->tiles, poses_of(model, state), clearance);
      if (close.empty()) return true;
      for (const Separation& pair : close) add_separation(model, pair);
      continue;
    }
    if (step == most_steps) return false;
    // Room to give way: two rings around what is violated.
    for (int ring = 0; ring < 2; ++ring) {
      for (int i : with_neighbours(model, chosen)) chosen[i] = 1;
    }
    StepPrices prices;
    prices.reach = std::max(0.2, 2 * worst);
    state +=
        least_layout_step(model, state, {}, with_neighbours(model, chosen), nullptr, prices).step;
  }
  return false;
}

}  // namespace curveups
