// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/repair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/physics/sensitivities.hpp"
#include "curveups/refinement/layout_step.hpp"

namespace curveups {
namespace {

// Normal forces over f_min, f_min being a share of their mean; contacts' points only.
struct Judgement {
  Eigen::VectorXd normal;  // N
  double mean = 0, f_min = 0;
  int weak = 0;
  double least = 0;    // in units of f_min
  double missing = 0;  // sum of what points lack, in units of f_min
  bool better_than(const Judgement& other) const {
    return weak != other.weak ? weak < other.weak : missing < other.missing;
  }
};

Judgement judge(const std::vector<ContactPoint>& points, const Eigen::VectorXd& normal,
                double ratio, double goal) {
  Judgement out;
  out.normal = normal;
  int count = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact < 0) continue;
    out.mean += normal(static_cast<Eigen::Index>(p));
    ++count;
  }
  out.mean /= std::max(1, count);
  out.f_min = ratio * out.mean;
  out.least = 1e300;
  if (!(out.f_min > 0)) {
    throw InfeasibleDesign("the membranes do not press the tiles together",
                           "raise tau, or lower p_max so that pins pull more strongly");
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact < 0) continue;
    const double f = normal(static_cast<Eigen::Index>(p)) / out.f_min;
    out.weak += f < 1;
    out.least = std::min(out.least, f);
    out.missing += std::max(0.0, goal - f);
  }
  return out;
}

class Repair {
 public:
  Repair(const Design& design, const RepairOptions& options, const Progress& progress)
      : options_(options),
        progress_(progress),
        parameters_(design.parameters),
        geometry_(make_geometry(design.mesh, design.cuts, design.parameters)),
        model_(make_layout_model(geometry_, design.parameters)) {
    const int count = geometry_.tiles.tile_count();
    if (design.T.rows() != count || design.q.rows() != count) {
      throw InvalidInput("the design's T and q do not have a row for each tile",
                         "give arrays of one design");
    }
    state_ = state_of(model_, fit_poses(geometry_.tiles, design.T), design.q);
  }

  RepairResult run(const Design& design);

 private:
  Judgement judge_here() const {
    return judge(forces_->system().points(), forces_->contact_forces().force.col(0) + correction_,
                 parameters_.f_min_ratio, options_.goal);
  }
  Judgement judge_fresh();
  void restore_start(RepairResult& result);
  bool take_step(RepairResult& result, Judgement& now);
  std::vector<ForceRow> force_rows(const Judgement& now);
  void tell(const Judgement& now) {
    const std::string what = "repair: " + std::to_string(now.weak) + " weak points";
    const double fraction = first_weak_ > 0 ? 1 - static_cast<double>(now.weak) / first_weak_ : 1;
    if (!keep_going(progress_, what, std::max(0.0, fraction))) throw Cancelled();
  }
  void explain(const Judgement& now, RepairResult& result) const;

  RepairOptions options_;
  Progress progress_;
  Parameters parameters_;
  DesignGeometry geometry_;
  LayoutModel model_;
  LayoutState state_;
  std::unique_ptr<DesignForces> forces_;
  Eigen::VectorXd correction_;  // fresh, extrapolated normal forces less those of the moving mesh
  double reach_ = 0;
  int first_weak_ = 0;
  std::vector<int> row_points_;
  LayoutStep last_step_;
};

// Meshes anew: the verdict, and the correction of the moving mesh from here on.
Judgement Repair::judge_fresh() {
  const FlatPoses poses = poses_of(model_, state_);
  const Array6 q = insets_of(state_);
  std::array<MembraneSolution, 2> fresh;
  if (!keep_going(progress_, "repair: fresh membranes")) throw Cancelled();
  parallel_pair(
      [&] { fresh[0] = solve_membrane(geometry_, poses, q, parameters_, Side::front, {}); },
      [&] { fresh[1] = solve_membrane(geometry_, poses, q, parameters_, Side::back, {}); });
  const GravityLoad gravity = gravity_load(geometry_, parameters_, {});
  const Points3 centres = tile_centres(geometry_.tiles);
  Wrenches loads = gravity.weight;
  for (const MembraneSolution& side : fresh) {
    add_wrenches(extrapolate<Points3>(side.forces, side.coarse_forces), side.pin_corners, centres,
                 loads);
  }
  std::vector<ContactPoint> points = interface_points(geometry_.tiles, geometry_.patches);
  points.insert(points.end(), gravity.ground.begin(), gravity.ground.end());
  BalanceSystem system(std::move(points), centres, parameters_.L, gravity.held);
  const Eigen::VectorXd exact = solve_contact_forces(system, loads).force.col(0);
  const Judgement now = judge(system.points(), exact, parameters_.f_min_ratio, options_.goal);
  if (now.weak > 0) {
    forces_ = std::make_unique<DesignForces>(geometry_, parameters_, poses, q, progress_);
    correction_ = exact - forces_->contact_forces().force.col(0);
  }
  return now;
}

// A spoiled design is put onto its constraints first.
void Repair::restore_start(RepairResult& result) {
  const PinBounds& bounds = geometry_.pin_bounds;
  const LayoutState given = state_;
  state_.rightCols<6>() = state_.rightCols<6>().cwiseMax(bounds.lower).cwiseMin(bounds.upper);
  result.restored_mm = std::max(largest_violation(model_, given),
                                (state_ - given).rightCols<6>().cwiseAbs().maxCoeff());
  if (result.restored_mm > tolerance::constraint) keep_going(progress_, "restoring the layout", 0);
  if (!restore_constraints(model_, state_, 40)) {
    throw InfeasibleDesign("the layout breaks constraints that small steps can't restore",
                           "lay the target out anew");
  }
}

// Points below the watched force, each with its exact gradient.
std::vector<ForceRow> Repair::force_rows(const Judgement& now) {
  const std::vector<ContactPoint>& points = forces_->system().points();
  row_points_.clear();
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact >= 0 &&
        now.normal(static_cast<Eigen::Index>(p)) < options_.watched * now.f_min) {
      row_points_.push_back(static_cast<int>(p));
    }
  }
  Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()),
                                                    static_cast<Eigen::Index>(row_points_.size()));
  for (std::size_t r = 0; r < row_points_.size(); ++r) {
    functions(row_points_[r], static_cast<Eigen::Index>(r)) = 1 / now.mean;
  }
  const std::vector<ForceGradient> gradients = force_gradients(*forces_, functions, {});
  std::vector<ForceRow> rows;
  for (std::size_t r = 0; r < row_points_.size(); ++r) {
    ForceRow row{(now.normal(row_points_[r]) - options_.goal * now.f_min) / now.mean,
                 LayoutState(state_.rows(), unknowns_per_tile)};
    row.gradient << gradients[r].by_pose, gradients[r].by_inset;
    for (int i = 0; i < state_.rows(); ++i) {
      // Poses turn about front corner 0, the layout's unknowns about the centroid.
      const Vec2 arm = PlaneRotation(state_(i, 2)) * model_.tiles[i].corner[0][0];
      row.gradient(i, 2) += left_of(arm).dot(Vec2(row.gradient(i, 0), row.gradient(i, 1)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// One accepted step, or false where none lifts the weak forces any more.
bool Repair::take_step(RepairResult& result, Judgement& now) {
  const std::vector<ForceRow> rows = force_rows(now);
  const std::vector<int> tiles = tiles_that_matter(model_, rows, 0.02);
  const LayoutState before = state_;
  while (reach_ > 1e-3) {
    last_step_ = least_layout_step(model_, before, rows, tiles, reach_);
    state_ = before + last_step_.step;
    bool sound = restore_constraints(model_, state_, 8);
    if (sound) {
      try {
        forces_->move(poses_of(model_, state_), insets_of(state_), progress_);
      } catch (const InvalidInput&) {  // the moving mesh turned over
        sound = false;
      } catch (const SolverFailure&) {
        sound = false;
      }
    }
    if (sound) {
      const Judgement next = judge_here();
      if (next.missing < now.missing * (1 - 1e-3)) {
        LayoutState move = state_ - before;
        move.col(2) *= angle_lever(model_);
        now = next;
        result.steps.push_back({now.weak, now.least, move.cwiseAbs().maxCoeff(), false});
        reach_ = std::min(2 * reach_, options_.reach);
        return true;
      }
    }
    reach_ *= 0.5;
  }
  state_ = before;
  return false;
}

void Repair::explain(const Judgement& now, RepairResult& result) const {
  const std::vector<ContactPoint>& points = forces_->system().points();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double force = now.normal(static_cast<Eigen::Index>(p)) / now.f_min;
    if (points[p].contact < 0 || force >= 1) continue;
    if (!result.blocked.empty() && result.blocked.back().tiles == points[p].tile) {
      result.blocked.back().least_force = std::min(result.blocked.back().least_force, force);
      continue;
    }
    result.blocked.push_back({points[p].tile, force, "", {}});
  }
  bool gaps = false, areas = false;
  for (BlockedContact& contact : result.blocked) {
    // Obstacles near the contact: on its tiles or their neighbours.
    std::vector<int> near = {contact.tiles[0], contact.tiles[1]};
    for (int tile : contact.tiles) {
      for (int t = 0; t < 3; ++t) {
        const int n = geometry_.tiles.topology.neighbour(tile, t);
        if (n >= 0) near.push_back(n);
      }
    }
    const Obstacle* found = nullptr;
    for (const Obstacle& obstacle : last_step_.obstacles) {
      const bool here = std::any_of(obstacle.tiles.begin(), obstacle.tiles.end(), [&](int tile) {
        return std::find(near.begin(), near.end(), tile) != near.end();
      });
      if (here) {
        found = &obstacle;
        break;
      }
    }
    char share[32];
    std::snprintf(share, sizeof share, "%.2f", contact.least_force);
    contact.reason = "contact " + tile_name(contact.tiles[0]) + "-" + tile_name(contact.tiles[1]) +
                     " has " + share + " of f_min";
    if (!found) {
      contact.reason += ": no small change of the layout lifts it";
      continue;
    }
    contact.held = found->tiles;
    contact.reason += ": held by the " + found->what + " of " + tile_names(found->tiles);
    gaps = gaps || found->what == "gap";
    areas = areas || found->what != "gap";
  }
  if (gaps) result.suggestions.push_back("a cut near the tiles named gives gaps room");
  if (areas) {
    result.suggestions.push_back(
        "a larger L, thinner tiles (H_body) or a smaller A_pin_min give pins room");
  }
}

RepairResult Repair::run(const Design& design) {
  RepairResult result;
  result.design = design;
  const LayoutState given = state_;
  LayoutState best = state_;
  Judgement best_judgement;
  bool judged = false;
  reach_ = options_.reach;
  auto keep = [&](const Judgement& now) {
    if (judged && !now.better_than(best_judgement)) return;
    best = state_;
    best_judgement = now;
    judged = true;
  };
  try {
    restore_start(result);
    while (true) {
      Judgement now = judge_fresh();
      if (!judged) first_weak_ = now.weak;
      result.steps.push_back({now.weak, now.least, 0, true});
      keep(now);
      tell(now);
      if (now.weak == 0) {
        result.status = RepairStatus::valid;
        break;
      }
      bool moved = false;
      // A tenth of f_min short of the goal is near enough for a fresh mesh to judge.
      while (static_cast<int>(result.steps.size()) <= options_.most_steps &&
             now.least < options_.goal - 0.1 && take_step(result, now)) {
        moved = true;
        tell(now);
      }
      if (!moved) {
        explain(now, result);
        break;
      }
    }
  } catch (const Cancelled&) {
    result.status = RepairStatus::stopped;
  }
  if (!judged) return result;
  if (best == given) return result;  // bit for bit what was given
  result.design.T = flat_corners(geometry_.tiles, poses_of(model_, best));
  result.design.q = insets_of(best);
  result.largest_move = std::max((result.design.T - design.T).cwiseAbs().maxCoeff(),
                                 (best - given).rightCols<6>().cwiseAbs().maxCoeff());
  return result;
}

}  // namespace

RepairResult repair_design(const Design& design, const RepairOptions& options,
                           const Progress& progress) {
  return Repair(design, options, progress).run(design);
}

}  // namespace curveups
