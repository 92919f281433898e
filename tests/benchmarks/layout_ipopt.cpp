// SPDX-License-Identifier: LGPL-2.1-or-later
// The flat layout by this project's interior-point method and by Ipopt (with MUMPS), on one thread:
// the same unknowns, energies, constraints, first and second derivatives, start and accuracy. Pairs
// beyond contacts are not kept apart here, as Ipopt could not be given them in the middle of a run.
//
//   layout_ipopt DESIGN.json ...     targets, cuts and parameters are taken from the designs
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpSolveStatistics.hpp>
#include <coin/IpTNLP.hpp>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>

#include "curveups/core/parallel.hpp"
#include "curveups/design/design_file.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

constexpr double mu_start = 1e-1, mu_end = 1e-6;  // as solve_layout has them
constexpr int W = unknowns_per_tile;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Places of the lower triangle of all 9 x 9 blocks that elements join, each once.
class Pattern {
 public:
  explicit Pattern(int tiles, const LayoutTerms& energies, const LayoutTerms& constraints) {
    std::vector<std::array<int, 2>> pairs;
    for (int i = 0; i < tiles; ++i) pairs.push_back({i, i});
    auto join = [&](const LayoutTerms& terms) {
      for (const auto& term : terms) {
        for (int e = 0; e < term->element_count(); ++e) {
          const auto [a, b] = term->blocks(e);
          if (b >= 0) pairs.push_back({std::max(a, b), std::min(a, b)});
        }
      }
    };
    join(energies);
    join(constraints);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    pairs_ = pairs;
    for (const auto& [high, low] : pairs_) {
      start_.push_back(size_);
      size_ += high == low ? W * (W + 1) / 2 : W * W;
    }
  }
  int size() const { return size_; }

  template <class Take>
  void each(const Take& take) const {  // take(row, column), in the order of storage
    for (const auto& [high, low] : pairs_) {
      for (int r = 0; r < W; ++r) {
        for (int c = 0; c < (high == low ? r + 1 : W); ++c) take(W * high + r, W * low + c);
      }
    }
  }

  // values += weight times the square of one row of an element's Jacobians.
  void add(const LayoutTerm& term, int element, const LayoutTerm::Value& value, int row,
           double weight, double* values) const {
    const auto blocks = term.blocks(element);
    for (int k = 0; k < 2 && blocks[k] >= 0; ++k) {
      for (int l = 0; l < 2 && blocks[l] >= 0; ++l) {
        if (blocks[k] < blocks[l]) continue;
        const auto at = std::lower_bound(pairs_.begin(), pairs_.end(),
                                         std::array<int, 2>{blocks[k], blocks[l]});
        double* to = values + start_[at - pairs_.begin()];
        for (int r = 0; r < W; ++r) {
          for (int c = 0; c < (k == l ? r + 1 : W); ++c, ++to) {
            *to += weight * value.jacobian[k](row, r) * value.jacobian[l](row, c);
          }
        }
      }
    }
  }

 private:
  std::vector<std::array<int, 2>> pairs_;
  std::vector<int> start_;
  int size_ = 0;
};

class LayoutProblem : public Ipopt::TNLP {
 public:
  LayoutProblem(const LayoutModel& model, LayoutState start)
      : state(std::move(start)),
        energies_(make_energies(model)),
        constraints_(make_constraints(model)),
        bounds_(inset_bounds(model)),
        pattern_(model.tile_count(), energies_, constraints_) {
    for (const auto& constraint : constraints_) rows_ += constraint->element_count();
  }

  bool get_nlp_info(int& n, int& m, int& jacobian, int& hessian, IndexStyleEnum& style) override {
    n = static_cast<int>(state.size());
    m = rows_;
    jacobian = 0;
    each_row(
        [&](const LayoutTerm& term, int e, int) { jacobian += term.blocks(e)[1] < 0 ? W : 2 * W; });
    hessian = pattern_.size();
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(int n, double* low, double* high, int m, double* least,
                       double* most) override {
    std::fill(low, low + n, -1e20);
    std::fill(high, high + n, 1e20);
    for (const auto& [block, unknown, lower, upper] : bounds_) {
      low[W * block + unknown] = lower;
      high[W * block + unknown] = upper;
    }
    std::fill(least, least + m, 0.0);
    std::fill(most, most + m, 1e20);
    return true;
  }
  bool get_starting_point(int n, bool, double* x, bool, double*, double*, int, bool,
                          double*) override {
    std::copy(state.data(), state.data() + n, x);
    return true;
  }
  bool eval_f(int, const double* x, bool, double& f) override {
    f = 0;
    for (const auto& energy : energies_) f += energy->value(at(x));
    return true;
  }
  bool eval_grad_f(int n, const double* x, bool, double* gradient) override {
    LayoutState sum = LayoutState::Zero(state.rows(), W);
    for (const auto& energy : energies_) energy->derivatives(at(x), sum, nullptr, 0);
    std::copy(sum.data(), sum.data() + n, gradient);
    return true;
  }
  bool eval_g(int, const double* x, bool, int, double* g) override {
    const LayoutState& z = at(x);
    LayoutTerm::Value value;
    each_row([&](const LayoutTerm& term, int e, int row) {
      term.at(e, z, false, value);
      g[row] = value.value(0);
    });
    return true;
  }
  bool eval_jac_g(int, const double* x, bool, int, int, int* rows, int* columns,
                  double* values) override {
    int k = 0;
    LayoutTerm::Value value;
    if (values) at(x);
    each_row([&](const LayoutTerm& term, int e, int row) {
      const auto blocks = term.blocks(e);
      if (values) term.at(e, state, true, value);
      for (int b = 0; b < 2 && blocks[b] >= 0; ++b) {
        for (int u = 0; u < W; ++u, ++k) {
          if (values) {
            values[k] = value.jacobian[b](0, u);
          } else {
            rows[k] = row;
            columns[k] = W * blocks[b] + u;
          }
        }
      }
    });
    return true;
  }
  bool eval_h(int, const double* x, bool, double factor, int, const double* multiplier, bool,
              int count, int* rows, int* columns, double* values) override {
    if (!values) {
      int k = 0;
      pattern_.each([&](int r, int c) { rows[k] = r, columns[k++] = c; });
      return true;
    }
    const LayoutState& z = at(x);
    std::fill(values, values + count, 0.0);
    LayoutTerm::Value value;
    for (const auto& energy : energies_) {
      for (int e = 0; e < energy->element_count(); ++e) {
        energy->at(e, z, true, value);
        for (int r = 0; r < energy->dimension() + energy->curvature_rows(); ++r) {
          pattern_.add(*energy, e, value, r, factor, values);
        }
      }
    }
    // Ipopt's multipliers of lower limits are negative.
    each_row([&](const LayoutTerm& term, int e, int row) {
      if (multiplier[row] >= 0 || term.curvature_rows() == 0) return;
      term.at(e, z, true, value);
      for (int r = 0; r < term.curvature_rows(); ++r) {
        pattern_.add(term, e, value, 1 + r, -multiplier[row], values);
      }
    });
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, int, const double* x, const double*, const double*,
                         int, const double*, const double*, double, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    at(x);
  }

  LayoutState state;

 private:
  const LayoutState& at(const double* x) {
    std::copy(x, x + state.size(), state.data());
    return state;
  }
  template <class Take>
  void each_row(const Take& take) const {
    int row = 0;
    for (const auto& constraint : constraints_) {
      for (int e = 0; e < constraint->element_count(); ++e) take(*constraint, e, row++);
    }
  }

  LayoutTerms energies_, constraints_;
  std::vector<Bound> bounds_;
  Pattern pattern_;
  int rows_ = 0;
};

double energy_of(const LayoutModel& model, const LayoutState& state) {
  double sum = 0;
  for (const auto& [name, value] : energies_by_name(make_energies(model), state)) sum += value;
  return sum;
}

void compare(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const Design design = read_design(text.str());
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const LayoutModel model = make_layout_model(geometry, design.parameters);
  const LayoutState start = initial_layout(model);

  LayoutState own = start;
  LayoutTerms energies = make_energies(model);
  double begun = processor_seconds();
  InteriorPoint method(
      {std::make_move_iterator(energies.begin()), std::make_move_iterator(energies.end())},
      make_constraints(model), inset_bounds(model));
  const SolveReport report = method.run(own, mu_start, mu_end, 600, "layout", {});
  const double own_seconds = processor_seconds() - begun;

  Ipopt::SmartPtr<LayoutProblem> problem = new LayoutProblem(model, start);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = IpoptApplicationFactory();
  ipopt->Options()->SetStringValue("linear_solver", "mumps");
  ipopt->Options()->SetStringValue("sb", "yes");
  ipopt->Options()->SetStringValue("nlp_scaling_method", "none");
  ipopt->Options()->SetNumericValue("mu_init", mu_start);
  // The products reach ten times mu_end and gradients a hundredth, as they do in the other method.
  ipopt->Options()->SetNumericValue("tol", 1e-2);
  ipopt->Options()->SetNumericValue("compl_inf_tol", 10 * mu_end);
  ipopt->Options()->SetNumericValue("constr_viol_tol", 1e-6);
  ipopt->Options()->SetNumericValue("dual_inf_tol", 1e-2);
  ipopt->Options()->SetIntegerValue("max_iter", 1000);
  ipopt->Options()->SetIntegerValue("print_level", 0);
  ipopt->Initialize();
  begun = processor_seconds();
  const Ipopt::ApplicationReturnStatus status = ipopt->OptimizeTNLP(problem);
  const double ipopt_seconds = processor_seconds() - begun;
  const double own_energy = energy_of(model, own), ipopt_energy = energy_of(model, problem->state);
  std::printf("%-16s %6d %5d%s %8.2f %5d%s %8.2f %6.1f %10.1e %9.1e %9.1e\n", design.name.c_str(),
              geometry.tiles.tile_count(), report.iterations, report.converged() ? " " : "!",
              own_seconds, ipopt->Statistics()->IterationCount(),
              status == Ipopt::Solve_Succeeded ? " " : "!", ipopt_seconds,
              ipopt_seconds / own_seconds, ipopt_energy / own_energy - 1, report.residual,
              largest_violation(make_constraints(model), problem->state));
  std::fflush(stdout);
}

}  // namespace
}  // namespace curveups

int main(int count, char** values) {
  curveups::set_thread_count(1);
  std::printf("%-16s %6s %6s %8s %6s %8s %6s %10s %9s %9s\n", "design", "tiles", "steps", "s",
              "Ipopt", "s", "ratio", "energy", "violated", "Ipopt");
  try {
    for (int k = 1; k < count; ++k) curveups::compare(values[k]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return 0;
}
