// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/layout_step.hpp"

#include <algorithm>
#include <cmath>

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

// Lever of angles, by which these are lengths like the other unknowns.
double angle_lever(const LayoutModel& model) { return model.L / std::sqrt(3.0); }

}  // namespace

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

namespace {

// Least-step problem of some tiles, nine unknowns each in mm, and of vertices behind them.
class StepProblem {
 public:
  StepProblem(const LayoutModel& model, const LayoutState& state,
              const std::vector<ForceRow>& forces, const std::vector<int>& tiles,
              const MovingVertices* vertices, const StepWeights& weights,
              const StepObjective* objective)
      : model_(model),
        state_(state),
        forces_(forces),
        tiles_(tiles),
        vertices_(vertices),
        weights_(weights),
        slot_(model.tile_count(), -1),
        own_(static_cast<int>(tiles.size()) * per_tile),
        count_(own_ + (vertices ? 3 * vertices->count() : 0)),
        vertex_scale_(vertices ? vertices->count() : 0) {
    for (std::size_t k = 0; k < tiles.size(); ++k) slot_[tiles[k]] = static_cast<int>(k);
    scale_.setOnes();
    scale_(2) /= angle_lever(model);
    for (int v = 0; v < vertex_scale_.size(); ++v) {
      vertex_scale_(v) = 1 / std::sqrt(weights.target * vertices->weight(v));
    }
    add_constraints();
    add_bounds();
    if (vertices) add_vertex_bounds();
    add_forces();
    if (objective) add_objective(*objective);
  }

  LayoutStep solve() const;

 private:
  bool moves(int tile) const { return tile >= 0 && slot_[tile] >= 0; }
  void add_constraints();
  bool add_constraint_row(const LayoutTerm& constraint, int element,
                          std::vector<Eigen::Triplet<double>>& entries);
  void add_bounds();
  void add_vertex_bounds();
  void add_forces();
  void add_objective(const StepObjective& objective);

  const LayoutModel& model_;
  const LayoutState& state_;
  const std::vector<ForceRow>& forces_;
  const std::vector<int>& tiles_;
  const MovingVertices* vertices_;
  StepWeights weights_;
  std::vector<int> slot_;                     // number of each tile among those that move, or -1
  int own_, count_;                           // unknowns of tiles, and with vertices
  Eigen::Matrix<double, 1, per_tile> scale_;  // unknowns per unit of the step
  Eigen::VectorXd vertex_scale_;
  LeastStepProblem problem_;
  std::vector<double> values_;  // per sparse row
};

// False where the step can't bring the constraint to its limit.
bool StepProblem::add_constraint_row(const LayoutTerm& constraint, int element,
                                     std::vector<Eigen::Triplet<double>>& entries) {
  const LayoutTerm::Blocks ends = constraint.blocks(element);
  if (!moves(ends[0]) && !moves(ends[1])) return false;
  LayoutTerm::Value value;
  constraint.at(element, state_, true, value);
  double most = vertices_ ? 6 * weights_.trust_radius : 0;  // largest decrease in this step
  for (int end = 0; end < 2; ++end) {
    if (!moves(ends[end])) continue;
    most +=
        value.jacobian[end].row(0).cwiseProduct(scale_).cwiseAbs().sum() * weights_.trust_radius;
  }
  if (value.value(0) > most) return false;
  for (int end = 0; end < 2; ++end) {
    if (!moves(ends[end])) continue;
    for (int k = 0; k < per_tile; ++k) {
      const double entry = value.jacobian[end](0, k) * scale_(k);
      if (entry == 0) continue;
      entries.emplace_back(static_cast<int>(values_.size()), slot_[ends[end]] * per_tile + k,
                           entry);
    }
  }
  values_.push_back(value.value(0));
  return true;
}

void StepProblem::add_constraints() {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<ConstraintRow> origin;
  const LayoutTerms constraints = make_constraints(model_);
  for (std::size_t f = 0; f < constraints.size(); ++f) {
    for (int e = 0; e < constraints[f]->element_count(); ++e) {
      if (add_constraint_row(*constraints[f], e, entries))
        origin.push_back({static_cast<int>(f), e});
    }
  }
  if (vertices_) {
    for (const VertexEntry& entry : rows_by_vertex(model_, state_, origin, *vertices_)) {
      for (int c = 0; c < 3; ++c) {
        entries.emplace_back(entry.row, own_ + 3 * entry.vertex + c,
                             entry.derivative(c) * vertex_scale_(entry.vertex));
      }
    }
  }
  problem_.sparse.resize(static_cast<Eigen::Index>(values_.size()), count_);
  problem_.sparse.setFromTriplets(entries.begin(), entries.end());
  problem_.sparse_value =
      Eigen::Map<const Eigen::VectorXd>(values_.data(), static_cast<Eigen::Index>(values_.size()));
}

void StepProblem::add_bounds() {
  problem_.lower = Eigen::VectorXd::Constant(count_, -weights_.trust_radius);
  problem_.upper = Eigen::VectorXd::Constant(count_, weights_.trust_radius);
  problem_.wanted = Eigen::VectorXd::Zero(count_);
  for (const Bound& bound : inset_bounds(model_)) {
    if (!moves(bound.block)) continue;
    const int at = slot_[bound.block] * per_tile + bound.unknown;
    const double now = state_(bound.block, bound.unknown);
    problem_.lower(at) = std::max(problem_.lower(at), bound.lower - now);
    problem_.upper(at) = std::min(problem_.upper(at), bound.upper - now);
  }
}

void StepProblem::add_vertex_bounds() {
  for (int v = 0; v < vertices_->count(); ++v) {
    for (int c = 0; c < 3; ++c) {
      const int at = own_ + 3 * v + c;
      const double moved = vertices_->moved(v, c), unit = vertex_scale_(v),
                   radius = weights_.trust_radius, farthest = weights_.largest_displacement;
      problem_.lower(at) = std::min(0.0, std::max(-radius, -farthest - moved)) / unit;
      problem_.upper(at) = std::max(0.0, std::min(radius, farthest - moved)) / unit;
      problem_.wanted(at) = -moved / unit;
    }
  }
}

void StepProblem::add_forces() {
  problem_.dense.resize(count_, static_cast<Eigen::Index>(forces_.size()));
  problem_.dense_value.resize(static_cast<Eigen::Index>(forces_.size()));
  for (std::size_t r = 0; r < forces_.size(); ++r) {
    auto column = problem_.dense.col(static_cast<Eigen::Index>(r));
    problem_.dense_value(static_cast<Eigen::Index>(r)) = forces_[r].value;
    for (std::size_t k = 0; k < tiles_.size(); ++k) {
      column.segment<per_tile>(static_cast<Eigen::Index>(k) * per_tile) =
          forces_[r].gradient.row(tiles_[k]).cwiseProduct(scale_).transpose();
    }
    for (int v = 0; v < vertex_scale_.size(); ++v) {
      column.segment<3>(own_ + 3 * v) = forces_[r].by_vertex.row(v).transpose() * vertex_scale_(v);
    }
  }
}

// Adds the objective in the units of a step.
void StepProblem::add_objective(const StepObjective& objective) {
  Eigen::VectorXd scale(count_);
  for (int k = 0; k < count_; ++k) scale(k) = scale_(k % per_tile);
  const SparseRows J = objective.jacobian * scale.asDiagonal();
  const auto by_rows = [&objective, J_T = SparseRows(J.transpose())](const Eigen::VectorXd& r) {
    return Eigen::VectorXd(objective.weight * (J_T * objective.solve(r)));
  };
  problem_.quadratic = [by_rows, J](const Eigen::VectorXd& z) { return by_rows(J * z); };
  problem_.linear = by_rows(objective.value);
}

LayoutStep StepProblem::solve() const {
  const Eigen::VectorXd z = solve_least_step(problem_).z;
  LayoutStep out;
  out.step = LayoutState::Zero(state_.rows(), per_tile);
  for (std::size_t k = 0; k < tiles_.size(); ++k) {
    out.step.row(tiles_[k]) = z.segment<per_tile>(static_cast<Eigen::Index>(k) * per_tile)
                                  .transpose()
                                  .cwiseProduct(scale_);
  }
  out.vertex_step.resize(vertex_scale_.size(), 3);
  for (int v = 0; v < vertex_scale_.size(); ++v) {
    out.vertex_step.row(v) = vertex_scale_(v) * z.segment<3>(own_ + 3 * v).transpose();
  }
  return out;
}

}  // namespace

LayoutStep least_layout_step(const LayoutModel& model, const LayoutState& state,
                             const std::vector<ForceRow>& forces, const std::vector<int>& tiles,
                             const MovingVertices* vertices, const StepWeights& weights,
                             const StepObjective* objective) {
  return StepProblem(model, state, forces, tiles, vertices, weights, objective).solve();
}

bool restore_constraints(LayoutModel& model, LayoutState& state, int max_steps) {
  constexpr double accuracy = 0.5 * tolerance::constraint;
  const double clearance = model.parameters.d_gap_min - accuracy;
  LayoutTerm::Value value;
  for (int step = 0; step <= max_steps; ++step) {
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
    if (step == max_steps) return false;
    // Two rings around the violated constraints move, too.
    for (int ring = 0; ring < 2; ++ring) {
      for (int i : with_neighbours(model, chosen)) chosen[i] = 1;
    }
    StepWeights weights;
    weights.trust_radius = std::max(0.2, 2 * worst);
    state +=
        least_layout_step(model, state, {}, with_neighbours(model, chosen), nullptr, weights).step;
  }
  return false;
}

}  // namespace curveups
