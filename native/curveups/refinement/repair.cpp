// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/repair.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/refinement/force_rows.hpp"
#include "curveups/refinement/friction_objective.hpp"
#include "curveups/refinement/pin_caps.hpp"

namespace curveups {
namespace {

// mm that an unknown moves in a step at most, at first.
constexpr double first_trust_radius = 0.2;
// Vertices stay within this times L of their places in the target, by coordinate.
constexpr double largest_displacement_of_L = 0.1;
// Cost of moving a vertex over that of moving a tile as far.
constexpr double vertex_cost = 100;

// Steps that lower friction: mm that an unknown moves at most; weight of the friction (in squares
// of the mean normal force) against the squares of moves, 1 / mm2; tangential force over the mean
// normal force, and the ratio of two in a row, that end the steps.
constexpr double shaping_radius = 0.5, friction_weight = 400, least_tangential = 0.005,
                 slow_shaping = 0.8;
constexpr int most_shaping_steps = 8;

// Deepest cut of either membrane.
std::vector<Finding> cuts_among(const std::vector<Touch>& touches) {
  std::vector<Finding> out;
  for (const Side side : {Side::front, Side::back}) {
    std::vector<MembraneClearance> clearances;
    for (const Touch& touch : touches) {
      if (touch.side == side) clearances.push_back({touch.clearance, touch.tile});
    }
    const MembraneClearance least = least_clearance(clearances, safe_clearance);
    if (!is_clear(least.distance)) {
      out.push_back(cut_by_membrane(side, least.tile, -least.distance));
    }
  }
  return out;
}

class Repair {
 public:
  Repair(const Design& design, const Progress& progress, const RepairCallback& callback,
         int max_steps, SolvedHandle solved);
  RepairResult run();

 private:
  // Place judged on a fresh mesh.
  struct Judged {
    Iterate place;
    Judgement judgement;
    std::vector<ContactPoint> points;
    std::vector<std::array<int, 2>> critical;  // contacts that bound the floor
    std::vector<Finding> cuts;                 // deepest cut of either membrane
  };

  std::shared_ptr<Shape> make_shape(const TriangleMesh& mesh, const LayoutModel* known) const;
  Design design_here() const;
  void restore_start(RepairResult& result);
  Judged judge_fresh(RepairResult& result);
  void search(RepairResult& result);
  void lower_friction(RepairResult& result);
  void shape(RepairResult& result);
  StepWeights step_weights() const;
  bool draw_pins_out(const Judgement& now);
  bool improve(RepairResult& result, Judgement& now);
  bool take_step(RepairResult& result, Judgement& now, bool with_vertices);
  bool move_to(const LayoutStep& step, const MovingVertices* moving, const Iterate& from);
  bool restore(int max_steps);
  void report(const Judgement& now) const;

  Progress progress_;
  RepairCallback callback_;
  int max_steps_;
  Design design_;        // as given
  SolvedHandle solved_;  // solution of the design given, or null
  SolvedHandle fresh_;   // solution of the place judged last, where that is valid
  const Parameters& parameters_;
  VertexPlaces target_;
  Array6 caps_;           // upper bounds of insets beside membranes that were too low
  Iterate given_, here_;  // the design given, and the present one
  TrackedForces tracked_;
  std::optional<Judged> best_;
  std::vector<Touch> touches_;
  double trust_radius_ = 0;
  int first_weak_ = 0;
};

Repair::Repair(const Design& design, const Progress& progress, const RepairCallback& callback,
               int max_steps, SolvedHandle solved)
    : progress_(progress),
      callback_(callback),
      max_steps_(max_steps),
      design_(design),
      solved_(std::move(solved)),
      parameters_(design_.parameters),
      target_{design.target ? design.target->V : design.mesh.V,
              Eigen::VectorXd::Zero(design.mesh.V.rows())},
      caps_(Array6::Constant(design.mesh.F.rows(), 6, std::numeric_limits<double>::infinity())),
      tracked_(design_.parameters, progress) {
  here_.shape = make_shape(design.mesh, nullptr);
  const TileMesh& tiles = here_.geometry().tiles;
  const int count = tiles.tile_count();
  if (target_.place.rows() != design.mesh.V.rows()) {
    throw InvalidInput("the design's target has other vertices than its mesh",
                       "give the target that the mesh was moved away from");
  }
  here_.state = state_of(here_.model(), fit_poses(tiles, design.T), design.q);
  given_ = here_;
  for (int i = 0; i < count; ++i) {
    for (int t = 0; t < 3; ++t) target_.area(tiles.mesh.F(i, t)) += tiles.area(i) / 3;
  }
}

// known: a model with the collisions known so far; or null.
std::shared_ptr<Shape> Repair::make_shape(const TriangleMesh& mesh,
                                          const LayoutModel* known) const {
  auto shape = std::make_shared<Shape>(mesh, design_.cuts, parameters_);
  apply_caps(caps_, shape->geometry);
  if (known) shape->model.gaps = known->gaps;
  return shape;
}

// The given design at the present place, bit for bit where that has not moved.
Design Repair::design_here() const {
  if (here_.vertices() == given_.vertices() && here_.state == given_.state) return design_;
  Design out = design_;
  if (here_.vertices() != given_.vertices()) {
    if (!out.target) out.target = out.mesh;
    out.mesh = here_.geometry().tiles.mesh;
  }
  out.T = flat_corners(here_.geometry().tiles, here_.poses());
  out.q = here_.insets();
  return out;
}

// Judges the present place on a fresh mesh, from which the moving mesh starts anew.
Repair::Judged Repair::judge_fresh(RepairResult& result) {
  if (!keep_going(progress_, "repair: fresh membranes")) throw Cancelled();
  const bool given = here_.vertices() == given_.vertices() && here_.state == given_.state;
  fresh_ = given && solved_ ? solved_
                            : std::make_shared<const SolvedDesign>(
                                  solve_design(here_.geometry(), design_here(), progress_));
  VerificationReport verification = verify_solved(here_.geometry(), fresh_, progress_, {true});
  const double floor = verification.complete ? verification.unilateral.largest_floor : no_floor;
  Judged out{here_,
             tracked_.judge_fresh(here_, *fresh_, floor),
             contact_corners(here_.geometry(), parameters_),
             {},
             {}};
  if (verification.complete && is_clear(verification.physics.clearance_mm) &&
      out.judgement.valid()) {
    result.verification = std::move(verification);
    return out;
  }
  touches_ = find_touches(here_.geometry(), *fresh_);
  out.cuts = cuts_among(touches_);
  for (const Touch& touch : touches_) {
    out.judgement.depth = std::max(out.judgement.depth, -touch.clearance);
  }
  tracked_.follow(here_, *fresh_, out.judgement);
  out.critical = tracked_.critical_pairs();
  fresh_.reset();
  return out;
}

// Puts a spoiled design onto its constraints.
void Repair::restore_start(RepairResult& result) {
  const LayoutState given = here_.state;
  here_.keep_pin_bounds();
  result.restored_mm = std::max(largest_violation(make_constraints(here_.model()), given),
                                (here_.state - given).rightCols<6>().cwiseAbs().maxCoeff());
  if (result.restored_mm > tolerance::constraint) {
    if (!keep_going(progress_, "restoring the layout", 0)) throw Cancelled();
  }
  if (!restore_constraints(here_.shape->model, here_.state, 40)) {
    throw InfeasibleDesign("the layout breaks constraints that small steps can't restore",
                           "lay the target out anew");
  }
}

StepWeights Repair::step_weights() const {
  StepWeights out;
  out.trust_radius = trust_radius_;
  out.largest_displacement = largest_displacement_of_L * parameters_.L;
  out.target = vertex_cost / (parameters_.L * parameters_.L);
  return out;
}

// False where the work fails: the moving mesh turned over, a tile lost its back face, or a solver
// broke down.
template <class Work>
bool succeeds(const Work& work) {
  try {
    return work();
  } catch (const InvalidInput&) {
  } catch (const InfeasibleDesign&) {
  } catch (const SolverFailure&) {
  }
  return false;
}

// Restores the constraints; forces follow. False where that fails.
bool Repair::restore(int max_steps) {
  here_.keep_pin_bounds();
  if (!restore_constraints(here_.shape->model, here_.state, max_steps)) return false;
  tracked_.move(here_);
  return true;
}

// Takes the step and restores the constraints. False where that fails.
bool Repair::move_to(const LayoutStep& step, const MovingVertices* moving, const Iterate& from) {
  here_ = from;
  return succeeds([&] {
    if (moving) {
      TriangleMesh mesh = from.geometry().tiles.mesh;
      for (int v = 0; v < moving->count(); ++v) {
        mesh.V.row(moving->vertex[v]) += step.vertex_step.row(v);
      }
      here_.shape = make_shape(mesh, &from.model());
      if (here_.geometry().truncation.unresolved.size() >
          from.geometry().truncation.unresolved.size()) {
        return false;
      }
    }
    here_.state += step.step;
    return restore(8);
  });
}

// Takes a step that lifts the weak forces; false where none does any more.
bool Repair::take_step(RepairResult& result, Judgement& now, bool with_vertices) {
  const Iterate from = here_;
  const UnilateralResult floor = tracked_.floor();
  MovingVertices chosen;
  if (with_vertices) chosen = vertices_to_move(here_, tracked_, now, target_);
  const MovingVertices* moving = chosen.count() > 0 ? &chosen : nullptr;
  const std::vector<ForceRow> rows = force_rows(here_, tracked_, now, moving);
  std::vector<int> tiles = tiles_that_matter(here_.model(), rows, 0.02);
  for (const VertexPatch& patch : chosen.patches) {
    for (int k : patch.changed) tiles.push_back(patch.tiles[k]);
  }
  sort_unique(tiles);
  for (; trust_radius_ > 1e-3; trust_radius_ *= 0.5) {
    const LayoutStep step =
        least_layout_step(from.model(), from.state, rows, tiles, moving, step_weights());
    if (!move_to(step, moving, from)) continue;
    const Judgement next = tracked_.judge();
    if (!(next.missing < now.missing * (1 - 1e-3))) continue;
    now = next;
    result.steps.push_back({now.weak, now.least, now.floor, moving != nullptr, false});
    trust_radius_ = std::min(2 * trust_radius_, first_trust_radius);
    return true;
  }
  here_ = from;
  tracked_.move_back(here_, floor);
  return false;
}

// Draws pins out where membranes cut into bodies or all but touch them; where forces suffice, only
// where they cut. False where no pin can, or the layout has no room for it.
bool Repair::draw_pins_out(const Judgement& now) {
  const Iterate from = here_;
  const Array6 caps = caps_;
  std::vector<Touch> touches = touches_;
  if (now.forces_do()) {
    touches.erase(std::remove_if(touches.begin(), touches.end(),
                                 [](const Touch& touch) { return is_clear(touch.clearance); }),
                  touches.end());
  }
  if (cap_insets(touches, here_, caps_)) {
    const bool restored = succeeds([&] {
      here_.shape = make_shape(from.geometry().tiles.mesh, &from.model());
      return restore(20);
    });
    if (restored) return true;
    here_ = from;
    tracked_.move_back(here_, tracked_.floor());
  }
  caps_ = caps;
  return false;
}

// True where forces are near enough to their goals for a fresh mesh.
bool reached(const Judgement& now) {
  return now.least >= force_goal - 0.1 && !(now.floor < floor_goal - 0.05);
}

// Steps until the goals are reached or nothing helps; false where no step did.
bool Repair::improve(RepairResult& result, Judgement& now) {
  bool moved = false, slow = false;
  trust_radius_ = first_trust_radius;
  while (static_cast<int>(result.steps.size()) <= max_steps_ && !reached(now)) {
    const double before = now.missing;
    if (take_step(result, now, slow)) {
      moved = true;
      // Vertices move, too, where poses and pins alone make slow progress.
      slow = now.missing > 0.8 * before;
      report(now);
    } else if (slow) {
      break;
    } else {
      slow = true;
      trust_radius_ = first_trust_radius;
    }
  }
  return moved;
}

void Repair::report(const Judgement& now) const {
  const std::string what = "repair: " + std::to_string(now.weak) + " weak points";
  const double fraction = first_weak_ > 0 ? 1 - static_cast<double>(now.weak) / first_weak_ : 1;
  if (!keep_going(progress_, what, std::max(0.0, fraction))) throw Cancelled();
  if (!callback_) return;
  const FlatCorners T = flat_corners(here_.geometry().tiles, here_.poses());
  const double violation = largest_violation(make_constraints(here_.model()), here_.state);
  if (!callback_(T, here_.insets(), now.weak, violation)) throw Cancelled();
}

// Alternates steps and fresh meshes until a place is valid or nothing helps any more.
void Repair::search(RepairResult& result) {
  restore_start(result);
  while (true) {
    const Judged judged = judge_fresh(result);
    Judgement now = judged.judgement;
    if (!best_) first_weak_ = now.weak;
    result.steps.push_back({now.weak, now.least, now.floor, false, true});
    if (!best_ || now.better_than(best_->judgement)) best_ = judged;
    report(now);
    if (now.valid()) return;
    const bool drawn = static_cast<int>(result.steps.size()) <= max_steps_ && draw_pins_out(now);
    // Steps beyond what forces need do not aim at membranes.
    if (now.forces_do() && !drawn) return;
    if (drawn) {
      now = tracked_.judge();
      result.steps.push_back({now.weak, now.least, now.floor, false, false});
    }
    if (!improve(result, now) && !drawn) return;
  }
}

// Takes Gauss-Newton steps of all poses and insets that lower the friction needed for balance,
// under the constraints of the layout and weak forces, as long as they make progress.
void Repair::lower_friction(RepairResult& result) {
  Judgement now = best_->judgement;
  tracked_.follow(here_, *fresh_, now);
  const Wrenches correction = fresh_->loads - tracked_.forces().loads();
  fresh_.reset();
  const auto objective_here = [&] {
    return std::make_unique<FrictionObjective>(here_.geometry(), parameters_, here_.poses(),
                                               tracked_.forces().loads() + correction, now.mean);
  };
  std::vector<int> all(here_.geometry().tiles.tile_count());
  std::iota(all.begin(), all.end(), 0);
  trust_radius_ = shaping_radius;
  auto objective = objective_here();
  const double first = objective->tangential();
  for (int k = 0; k < most_shaping_steps && objective->tangential() > least_tangential; ++k) {
    const std::string what = "repair: friction needed";
    if (!keep_going(progress_, what, 1 - objective->tangential() / first)) throw Cancelled();
    const Iterate from = here_;
    StepObjective local = objective->linearise(here_, tracked_.forces());
    local.weight = friction_weight;
    LayoutStep step =
        least_layout_step(from.model(), from.state, force_rows(here_, tracked_, now, nullptr), all,
                          nullptr, step_weights(), &local);
    std::unique_ptr<FrictionObjective> next;
    int halved = 0;
    for (; halved < 4; ++halved, step.step *= 0.5) {
      if (!move_to(step, nullptr, from)) continue;
      next = objective_here();
      if (next->value() < objective->value()) break;
      next.reset();
    }
    if (!next) {
      here_ = from;
      tracked_.move(here_);
      return;
    }
    now = tracked_.judge();
    result.steps.push_back({now.weak, now.least, now.floor, false, false});
    const bool slow = halved == 0 && next->tangential() > slow_shaping * objective->tangential();
    objective = std::move(next);
    if (slow) return;
  }
}

// Lowers friction from a valid place, judged last, which stays the best where no other is valid.
void Repair::shape(RepairResult& result) {
  const Judged valid = *best_;
  const std::optional<VerificationReport> verification = result.verification;
  const double restored = result.restored_mm;
  const auto go_back = [&] {
    best_ = valid;
    result.verification = verification;
  };
  try {
    lower_friction(result);
    best_.reset();
    search(result);
  } catch (...) {
    go_back();
    throw;
  }
  result.restored_mm = restored;
  if (!best_->judgement.valid()) go_back();
}

RepairResult Repair::run() {
  RepairResult result;
  try {
    search(result);
    if (parameters_.self_shaping && best_->judgement.valid()) shape(result);
  } catch (const Cancelled&) {
    result.solve.status = SolveStatus::stopped;
  } catch (const Error& error) {  // on the way: the best so far stands
    if (!best_) throw;
    result.breakdown = error.what();
  }
  const Finishing finishing;
  here_ = best_ ? best_->place : given_;
  if (best_ && best_->judgement.valid() && result.solve.status == SolveStatus::unfinished) {
    result.solve.status = SolveStatus::converged;
  }
  if (result.solve.status == SolveStatus::unfinished) {
    result.blocked = weak_contacts(best_->points, best_->judgement, best_->critical);
  }
  if (best_) result.cuts = best_->cuts;
  result.design = design_here();
  result.largest_move = std::max((result.design.T - design_.T).cwiseAbs().maxCoeff(),
                                 (here_.state - given_.state).rightCols<6>().cwiseAbs().maxCoeff());
  result.largest_vertex_move = (result.design.mesh.V - design_.mesh.V).rowwise().norm().maxCoeff();
  return result;
}

}  // namespace

RepairResult repair_design(const Design& design, const Progress& progress,
                           const RepairCallback& callback, int max_steps, SolvedHandle solved) {
  return Repair(design, progress, callback, max_steps, std::move(solved)).run();
}

}  // namespace curveups
