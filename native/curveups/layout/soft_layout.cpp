// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/soft_layout.hpp"

#include <ceres/ceres.h>

#include <algorithm>

#include "curveups/core/checkpoint.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/layout_terms.hpp"
#include "curveups/numerics/one_thread.hpp"

namespace curveups {
namespace {

// One block of one energy term as Ceres wants it.
class BlockCost : public ceres::CostFunction {
 public:
  BlockCost(const LayoutTerm& term, int block) : term_(term), block_(block) {
    set_num_residuals(term.dimension());
    mutable_parameter_block_sizes()->assign(term.blocks(block)[1] < 0 ? 1 : 2, unknowns_per_tile);
  }

  bool Evaluate(const double* const* unknowns, double* residuals,
                double** jacobians) const override {
    const std::size_t tiles = parameter_block_sizes().size();
    LayoutTerm::Value value;
    term_.evaluate(block_, {unknowns[0], tiles > 1 ? unknowns[1] : nullptr}, jacobians != nullptr,
                   value);
    const int rows = term_.dimension();
    std::copy_n(value.value.data(), rows, residuals);
    for (std::size_t k = 0; jacobians && k < tiles; ++k) {
      if (jacobians[k])
        std::copy_n(value.jacobian[k].data(), rows * unknowns_per_tile, jacobians[k]);
    }
    return true;
  }

 private:
  const LayoutTerm& term_;
  int block_;
};

class Watcher : public ceres::IterationCallback {
 public:
  Watcher(const LayoutModel& model, const LayoutState& state, int max_iterations,
          const Progress& progress, const LayoutCallback& callback)
      : model_(model),
        state_(state),
        max_iterations_(max_iterations),
        progress_(progress),
        callback_(callback) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    const double share = static_cast<double>(summary.iteration) / std::max(1, max_iterations_);
    if (!keep_going(progress_, "soft layout", share)) return ceres::SOLVER_ABORT;
    if (!callback_ || !summary.step_is_successful) return ceres::SOLVER_CONTINUE;
    const double violation = largest_violation(make_constraints(model_), state_);
    return callback_(poses_of(model_, state_), insets_of(state_), 2 * summary.cost, violation)
               ? ceres::SOLVER_CONTINUE
               : ceres::SOLVER_ABORT;
  }

 private:
  const LayoutModel& model_;
  const LayoutState& state_;
  int max_iterations_;
  const Progress& progress_;
  const LayoutCallback& callback_;
};

}  // namespace

LayoutResult solve_soft_layout(const DesignGeometry& geometry, const Parameters& parameters,
                               const std::optional<SoftLayoutStart>& start, int max_iterations,
                               const Progress& progress, const LayoutCallback& callback) {
  const LayoutModel model = make_layout_model(geometry, parameters);
  LayoutState state = start ? state_of(model, start->poses, start->q) : initial_layout(model);
  const PinBounds& bounds = geometry.pin_bounds;
  state.rightCols<6>() = state.rightCols<6>().cwiseMax(bounds.lower).cwiseMin(bounds.upper);

  const LayoutTerms energies = make_energies(model, true);
  ceres::Problem problem;
  for (int i = 0; i < model.tile_count(); ++i) {
    double* own = state.row(i).data();
    problem.AddParameterBlock(own, unknowns_per_tile);
    for (int k = 0; k < 6; ++k) {
      problem.SetParameterLowerBound(own, 3 + k, bounds.lower(i, k));
      problem.SetParameterUpperBound(own, 3 + k, bounds.upper(i, k));
    }
  }
  for (const auto& energy : energies) {
    for (int b = 0; b < energy->element_count(); ++b) {
      const auto [i, j] = energy->blocks(b);
      if (j < 0) {
        problem.AddResidualBlock(new BlockCost(*energy, b), nullptr, state.row(i).data());
      } else {
        problem.AddResidualBlock(new BlockCost(*energy, b), nullptr, state.row(i).data(),
                                 state.row(j).data());
      }
    }
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = 1e-5;
  options.logging_type = ceres::SILENT;
  options.update_state_every_iteration = true;
  Watcher watcher(model, state, max_iterations, progress, callback);
  options.callbacks.push_back(&watcher);
  ceres::Solver::Summary summary;
  {
    const OneThread guard;
    ceres::Solve(options, &problem, &summary);
  }
  const Finishing finishing;
  LayoutResult result;
  result.poses = poses_of(model, state);
  result.T = flat_corners(geometry.tiles, result.poses);
  result.q = insets_of(state);
  result.solve.iterations = static_cast<int>(summary.iterations.size()) - 1;
  if (summary.termination_type == ceres::CONVERGENCE) result.solve.status = SolveStatus::converged;
  if (summary.termination_type == ceres::USER_FAILURE) result.solve.status = SolveStatus::stopped;
  result.energies = energies_by_name(energies, state);
  return result;
}

}  // namespace curveups
