// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/cut_suggestions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/flat_rim.hpp"
#include "curveups/geometry/cut_graph.hpp"
#include "curveups/layout/layout.hpp"

namespace curveups {
namespace {

constexpr int max_drafts = 3;
constexpr double worth = 0.03;  // least share by which a cut must lower Eq. 9's energy per contact
// Largest scale spread of a map for a draft layout: beyond it maps alone choose.
constexpr double workable_spread = 20;

Edges with(const Edges& a, const Edges& b) {
  Edges out(a.rows() + b.rows(), 2);
  out << a, b;
  return out;
}

// Variance of the log scale over the area.
double unevenness(const TileMesh& tiles, const Eigen::VectorXd& scale) {
  const Eigen::ArrayXd log = scale.array().log();
  return (tiles.area.array() * log.square()).sum() / tiles.area.sum();
}

double energy_of(const std::optional<LayoutFigures>& figures) {
  return figures ? figures->energy : std::numeric_limits<double>::infinity();
}

// Sides of tiles that have room for a pin, however small.
int feasible_sides(const PinBounds& bounds) {
  return static_cast<int>((bounds.least_area.array() > 0).count());
}

struct Tried {
  CutCandidate cut;
  double unevenness = 0;
  int feasible_sides = 0;
  std::optional<LayoutFigures> figures;
};

class Suggester {
 public:
  Suggester(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters,
            const CutSuggestionOptions& options, const Progress& progress)
      : mesh_(mesh), parameters_(parameters), options_(options), progress_(progress), cuts_(cuts) {}

  CutSuggestions run() {
    try {
      open();
      while (static_cast<int>(out_.cuts.size()) < options_.most && add_best()) {
      }
      out_.solve.status = SolveStatus::converged;
    } catch (const Cancelled&) {
      out_.solve.status = SolveStatus::stopped;
    }
    return std::move(out_);
  }

 private:
  TileMesh tiles_with(const Edges& more) const {
    return make_tile_mesh(mesh_, with(cuts_, more), parameters_.H_body);
  }

  bool go_on() const {
    return keep_going(progress_, "looking for cuts",
                      static_cast<double>(out_.cuts.size()) / std::max(1, options_.most));
  }

  // Figures of a draft layout; none where the solver breaks down, or the sheet would lie on itself.
  // Throws Cancelled.
  std::optional<LayoutFigures> draft(const Edges& more) const {
    const Progress progress = [this](const std::string&, double) { return go_on(); };
    try {
      const DesignGeometry geometry = make_geometry(mesh_, with(cuts_, more), parameters_);
      const LayoutResult result =
          solve_layout(geometry, parameters_, progress, LayoutEffort::draft);
      if (result.solve.stopped()) throw Cancelled();
      const TileMesh& tiles = geometry.tiles;
      const FlatCorners corners = flat_corners(tiles, result.poses);
      if (!crossing_rims(tiles, Eigen::Map<const Points2>(corners.data(), 3 * corners.rows(), 2))
               .empty()) {
        return {};
      }
      return layout_figures(geometry, parameters_, result.poses, result.q);
    } catch (const SolverFailure&) {
      return {};
    } catch (const InfeasibleDesign&) {
      return {};
    }
  }

  // Suggest the cuts without which the target can't lie flat, as one.
  void open() {
    const Edges none(0, 2);
    const TileMesh given = tiles_with(none);
    CutSuggestion needed;
    needed.edges = opening_cuts(mesh_, given.topology, given.cut);
    if (needed.edges.rows() > 0) needed.reasons.push_back({"cut.opens"});
    while (true) {
      if (!go_on()) throw Cancelled();
      const TileMesh tiles = tiles_with(needed.edges);
      const Eigen::VectorXd scale = relative_scale(tiles);
      if (scale_spread(scale) <= workable_spread) break;
      const std::vector<Tried> tried = candidates(tiles, scale, needed.edges);
      if (tried.empty() || !(tried.front().unevenness < unevenness(tiles, scale))) break;
      needed.edges = with(needed.edges, tried.front().cut.edges);
      needed.reasons.push_back(tried.front().cut.reason);
    }
    if (needed.edges.rows() == 0 || options_.most < 1) return;
    needed.after = draft(needed.edges);
    ++out_.solve.iterations;
    take(std::move(needed));
  }

  // Candidates, those with the most even maps first.
  std::vector<Tried> candidates(const TileMesh& tiles, const Eigen::VectorXd& scale,
                                const Edges& pending) const {
    std::vector<Tried> tried;
    for (CutCandidate& cut : cut_candidates(tiles, scale, options_.weak)) {
      tried.push_back({std::move(cut), 0, 0, {}});
    }
    parallel_for(static_cast<int>(tried.size()), [&](int k) {
      const DesignGeometry cut =
          make_geometry(mesh_, with(with(cuts_, pending), tried[k].cut.edges), parameters_);
      checkpoint();
      tried[k].unevenness = unevenness(cut.tiles, relative_scale(cut.tiles));
      tried[k].feasible_sides = feasible_sides(cut.pin_bounds);
    });
    // Along a cut tiles are truncated further, which may take all room from a pin.
    const int sides =
        feasible_sides(make_geometry(mesh_, with(cuts_, pending), parameters_).pin_bounds);
    tried.erase(std::remove_if(tried.begin(), tried.end(),
                               [&](const Tried& t) { return t.feasible_sides < sides; }),
                tried.end());
    std::stable_sort(tried.begin(), tried.end(),
                     [](const Tried& a, const Tried& b) { return a.unevenness < b.unevenness; });
    return tried;
  }

  // Suggest the best cut; false where none is worth making.
  bool add_best() {
    if (!go_on()) throw Cancelled();
    const Edges none(0, 2);
    const TileMesh tiles = tiles_with(none);
    std::vector<Tried> tried = candidates(tiles, relative_scale(tiles), none);
    if (tried.empty()) return false;
    if (tried.size() > max_drafts) tried.resize(max_drafts);
    if (!drafted_) {
      now_ = draft(none);
      drafted_ = true;
      ++out_.solve.iterations;
    }
    parallel_for(static_cast<int>(tried.size()),
                 [&](int k) { tried[k].figures = draft(tried[k].cut.edges); });
    out_.solve.iterations += static_cast<int>(tried.size());
    const auto best = std::min_element(
        tried.begin(), tried.end(),
        [](const Tried& a, const Tried& b) { return energy_of(a.figures) < energy_of(b.figures); });
    if (!(energy_of(best->figures) < (1 - worth) * energy_of(now_))) return false;
    take({best->cut.edges, 0, {best->cut.reason}, now_, best->figures});
    return true;
  }

  void take(CutSuggestion&& cut) {
    cut.length = length_of(mesh_, cut.edges);
    cuts_ = with(cuts_, cut.edges);
    now_ = cut.after;
    drafted_ = true;
    out_.cuts.push_back(std::move(cut));
  }

  const TriangleMesh& mesh_;
  const Parameters& parameters_;
  const CutSuggestionOptions& options_;
  const Progress& progress_;
  Edges cuts_;                        // given and suggested cuts
  std::optional<LayoutFigures> now_;  // of the layout with cuts_
  bool drafted_ = false;              // now_ is known
  CutSuggestions out_;
};

}  // namespace

CutSuggestions suggest_cuts(const TriangleMesh& mesh, const Edges& cuts,
                            const Parameters& parameters, const CutSuggestionOptions& options,
                            const Progress& progress) {
  return Suggester(mesh, cuts, parameters, options, progress).run();
}

}  // namespace curveups
