// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/repair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/physics/clearance.hpp"
#include "curveups/physics/sensitivities.hpp"
#include "curveups/refinement/explanation.hpp"
#include "curveups/refinement/judgement.hpp"
#include "curveups/refinement/layout_step.hpp"

namespace curveups {
namespace {

constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();
// Where tightness is a penalty: what moving a tile by L / ease costs against Eq. 3, next to
// nothing.
constexpr double ease = 0.1;
// Where it is hard: what moving a vertex costs against moving a tile as far.
constexpr double reluctance = 100;

// Tiles for vertices where they are, and the layout's constraints on them.
struct Shape {
  DesignGeometry geometry;
  LayoutModel model;  // of that geometry

  Shape(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters)
      : geometry(make_geometry(mesh, cuts, parameters)),
        model(make_layout_model(geometry, parameters)) {}
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
};

// A pin side beside which a membrane cuts into a body.
struct Touch {
  int tile;
  Side side;
  double depth;  // mm
};

// All unknowns; those of the vertices in the shape.
struct Place {
  std::shared_ptr<Shape> shape;
  LayoutState state;
};

class Repair {
 public:
  Repair(const Design& design, const RepairOptions& options, SolvedDesign* solved,
         const Progress& progress);
  RepairResult run(const Design& design);

 private:
  const DesignGeometry& geometry() const { return here_.shape->geometry; }
  const LayoutModel& model() const { return here_.shape->model; }
  const Points3& vertices() const { return geometry().tiles.mesh.V; }
  bool penalty() const { return parameters_.tightness == "penalty"; }

  std::shared_ptr<Shape> make_shape(const TriangleMesh& mesh) const;
  void restore_start(RepairResult& result);
  Judgement judge_fresh(RepairResult& result);
  Judgement judge_loads(const Wrenches& loads, bool with_floor) const;
  Judgement judge_here();
  UnilateralResult unilateral(const Wrenches& loads) const;
  double merit(const Judgement& now) const;

  bool draw_pins_out();
  bool improve(RepairResult& result, Judgement& now);
  bool reached(const Judgement& now) const;
  bool take_step(RepairResult& result, Judgement& now, bool with_vertices);
  bool move_to(const LayoutStep& step, const MovingVertices* moving, const Place& from);
  StepPrices prices() const;
  MovingVertices moving_vertices(const Judgement& now) const;
  std::vector<ForceRow> force_rows(const Judgement& now, const MovingVertices* moving) const;
  ForceRow make_row(double value, double unit, const ForceGradient& gradient,
                    const MovingVertices* moving) const;
  void tell(const Judgement& now) const;

  RepairOptions options_;
  SolvedDesign* solved_;
  Progress progress_;
  Parameters parameters_;
  Edges cuts_;
  Points3 target_;
  Eigen::VectorXd weight_;  // A_j of Eq. 4
  Place here_;
  std::unique_ptr<DesignForces> forces_;
  // What a fresh mesh, extrapolated, gave beyond the moving one: normal forces and the floor, N.
  Eigen::VectorXd correction_;
  double floor_correction_ = 0;
  double f_min_ratio_;
  bool watch_floor_ = false;
  UnilateralResult floor_;  // on the moving mesh, where it is watched
  double reach_ = 0;
  int first_weak_ = 0;
  LayoutStep last_step_;
  Array6 caps_;  // upper bounds of insets beside membranes that were too low
  std::vector<Touch> touches_;
};

Repair::Repair(const Design& design, const RepairOptions& options, SolvedDesign* solved,
               const Progress& progress)
    : options_(options),
      solved_(solved && solved->belongs_to(design) ? solved : nullptr),
      progress_(progress),
      parameters_(design.parameters),
      cuts_(design.cuts),
      target_(design.target ? design.target->V : design.mesh.V),
      f_min_ratio_(design.parameters.f_min_ratio) {
  caps_ = Array6::Constant(design.mesh.F.rows(), 6, std::numeric_limits<double>::infinity());
  here_.shape = make_shape(design.mesh);
  const TileMesh& tiles = geometry().tiles;
  const int count = tiles.tile_count();
  if (design.T.rows() != count || design.q.rows() != count) {
    throw InvalidInput("the design's T and q do not have a row for each tile",
                       "give arrays of one design");
  }
  if (target_.rows() != design.mesh.V.rows()) {
    throw InvalidInput("the design's target has other vertices than its mesh",
                       "give the target that the mesh was moved away from");
  }
  here_.state = state_of(model(), fit_poses(tiles, design.T), design.q);
  weight_ = Eigen::VectorXd::Zero(target_.rows());
  for (int i = 0; i < count; ++i) {
    for (int t = 0; t < 3; ++t) weight_(tiles.mesh.F(i, t)) += tiles.area(i) / 3;
  }
}

std::shared_ptr<Shape> Repair::make_shape(const TriangleMesh& mesh) const {
  auto shape = std::make_shared<Shape>(mesh, cuts_, parameters_);
  PinBounds& bounds = shape->geometry.pin_bounds;
  bounds.upper = bounds.upper.cwiseMin(caps_.cwiseMax((bounds.lower.array() + 0.005).matrix()));
  return shape;
}

UnilateralResult Repair::unilateral(const Wrenches& loads) const {
  BalanceSystem system = make_balance_system(geometry(), parameters_);
  const ContactForces start = solve_contact_forces(system, loads);
  UnilateralOptions options;
  options.friction_coefficient = parameters_.friction_coefficient;
  options.scale = start.normal_mean;
  return solve_unilateral(system, loads, start.force, options, progress_);
}

Judgement Repair::judge_loads(const Wrenches& loads, bool with_floor) const {
  BalanceSystem system = make_balance_system(geometry(), parameters_);
  const Eigen::VectorXd normal = solve_contact_forces(system, loads).force.col(0);
  const double floor = with_floor ? unilateral(loads).largest_floor : not_computed;
  return judge(system.points(), normal, floor, f_min_ratio_, options_);
}

// Meshes anew, where nobody has: the verdict, and the correction of the moving mesh from here on.
Judgement Repair::judge_fresh(RepairResult& result) {
  const TileMesh& tiles = geometry().tiles;
  SolvedDesign fresh;
  if (solved_) {
    fresh = std::move(*solved_);
    solved_ = nullptr;
    f_min_ratio_ = fresh.f_min_ratio;
  } else {
    if (!keep_going(progress_, "repair: fresh membranes")) throw Cancelled();
    fresh.mesh = tiles.mesh;
    fresh.T = flat_corners(tiles, poses_of(model(), here_.state));
    fresh.q = insets_of(here_.state);
    fresh.f_min_ratio = f_min_ratio_;
    // As verification of the design will have them.
    fresh.membranes =
        solve_membranes(geometry(), fit_poses(tiles, fresh.T), fresh.q, parameters_, progress_);
    fresh.loads = gravity_load(geometry(), parameters_, {}).weight;
    for (const MembraneSolution& side : fresh.membranes) {
      add_wrenches(extrapolate<Points3>(side.forces, side.coarse_forces), side.pin_corners,
                   tile_centres(tiles), fresh.loads);
    }
  }
  Judgement now = judge_loads(fresh.loads, watch_floor_);
  if (now.weak == 0 && !watch_floor_) {
    now = judge_loads(fresh.loads, true);
    watch_floor_ = !now.valid();
  }
  touches_.clear();
  for (Side side : {Side::front, Side::back}) {
    for (const MembraneClearance& one :
         patch_clearances(geometry(), fresh.membranes[static_cast<int>(side)], parameters_.H_pin)) {
      if (!(one.distance < 0)) continue;
      touches_.push_back({one.tile, side, -one.distance});
      now.depth = std::max(now.depth, -one.distance);
    }
  }
  if (now.valid()) {
    result.solved = std::make_shared<SolvedDesign>(std::move(fresh));
    return now;
  }
  forces_ = std::make_unique<DesignForces>(
      geometry(), parameters_,
      std::array<SolvedMembrane, 2>{std::move(fresh.membranes[0].coarse),
                                    std::move(fresh.membranes[1].coarse)},
      poses_of(model(), here_.state), insets_of(here_.state));
  correction_ = now.normal - forces_->contact_forces().force.col(0);
  if (watch_floor_) {
    floor_ = unilateral(forces_->loads());
    floor_correction_ = now.floor * now.f_min - floor_.largest_floor;
  }
  return now;
}

Judgement Repair::judge_here() {
  if (watch_floor_) floor_ = unilateral(forces_->loads());
  const double floor = watch_floor_ ? floor_.largest_floor + floor_correction_ : not_computed;
  Eigen::VectorXd normal = forces_->contact_forces().force.col(0);
  // Where a contact point came or went with the vertices the next fresh mesh has to tell.
  if (normal.size() == correction_.size()) normal += correction_;
  return judge(forces_->system().points(), normal, floor, f_min_ratio_, options_);
}

// What steps must lower: what forces lack, or Eq. 3 in units of L^4 and of the mean normal force.
double Repair::merit(const Judgement& now) const {
  if (!penalty()) return now.missing;
  const double E_target =
      weight_.dot((vertices() - target_).rowwise().squaredNorm()) / std::pow(parameters_.L, 4);
  return E_target + parameters_.w_tight * now.missing_squares;
}

// A spoiled design is put onto its constraints first.
void Repair::restore_start(RepairResult& result) {
  const PinBounds& bounds = geometry().pin_bounds;
  const LayoutState given = here_.state;
  here_.state.rightCols<6>() =
      here_.state.rightCols<6>().cwiseMax(bounds.lower).cwiseMin(bounds.upper);
  result.restored_mm = std::max(largest_violation(model(), given),
                                (here_.state - given).rightCols<6>().cwiseAbs().maxCoeff());
  if (result.restored_mm > tolerance::constraint) {
    if (!keep_going(progress_, "restoring the layout", 0)) throw Cancelled();
    solved_ = nullptr;
  }
  if (!restore_constraints(here_.shape->model, here_.state, 40)) {
    throw InfeasibleDesign("the layout breaks constraints that small steps can't restore",
                           "lay the target out anew");
  }
}

// The vertices of the tiles at points that must be lifted, and of the tiles next to these.
MovingVertices Repair::moving_vertices(const Judgement& now) const {
  const TileMesh& tiles = geometry().tiles;
  const std::vector<ContactPoint>& points = forces_->system().points();
  std::vector<char> near(tiles.tile_count(), 0), chosen(target_.rows(), 0);
  auto mark = [&](const ContactPoint& point) {
    for (int tile : point.tile) {
      if (tile < 0) continue;
      near[tile] = 1;
      for (int t = 0; t < 3; ++t) {
        if (const int n = tiles.topology.neighbour(tile, t); n >= 0) near[n] = 1;
      }
    }
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact < 0) continue;
    if (now.normal(static_cast<Eigen::Index>(p)) < options_.goal * now.f_min) mark(points[p]);
  }
  if (watch_floor_) {
    for (int p : floor_.critical_points) mark(points[p]);
  }
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3 && near[i]; ++t) chosen[tiles.mesh.F(i, t)] = 1;
  }
  const VertexPatches patches(geometry());
  MovingVertices out;
  for (int v = 0; v < target_.rows(); ++v) {
    if (!chosen[v]) continue;
    out.vertex.push_back(v);
    out.patches.push_back(patches.around(v));
  }
  out.moved.resize(out.count(), 3);
  out.weight.resize(out.count());
  for (int k = 0; k < out.count(); ++k) {
    out.moved.row(k) = vertices().row(out.vertex[k]) - target_.row(out.vertex[k]);
    out.weight(k) = weight_(out.vertex[k]);
  }
  return out;
}

ForceRow Repair::make_row(double value, double unit, const ForceGradient& gradient,
                          const MovingVertices* moving) const {
  const TileMesh& tiles = geometry().tiles;
  ForceRow row{value, LayoutState(here_.state.rows(), unknowns_per_tile), gradient.by_vertex};
  row.gradient << gradient.by_pose, gradient.by_inset;
  for (int i = 0; i < here_.state.rows(); ++i) {
    // Poses turn about front corner 0, the layout's unknowns about the centroid.
    const Vec2 arm = PlaneRotation(here_.state(i, 2)) * model().tiles[i].corner[0][0];
    row.gradient(i, 2) += left_of(arm).dot(Vec2(row.gradient(i, 0), row.gradient(i, 1)));
  }
  for (int v = 0; moving && v < moving->count(); ++v) {
    // And corner 0 moves about the centroid, which is held, as the vertex changes the tile.
    const VertexPatch& patch = moving->patches[v];
    for (int k : patch.changed) {
      const int tile = patch.tiles[k];
      for (int t = 0; t < 3; ++t) {
        if (tiles.mesh.F(tile, t) != moving->vertex[v]) continue;
        const PlaneRotation back(-here_.state(tile, 2));
        const Vec2 pull = back * Vec2(gradient.by_pose(tile, 0), gradient.by_pose(tile, 1));
        row.by_vertex.row(v) -= pull.transpose() * centroid_by_corner(tiles, tile, t);
      }
    }
  }
  row.gradient *= unit;
  row.by_vertex *= unit;
  return row;
}

// Points below the watched force, each with its exact gradient, and the floor.
std::vector<ForceRow> Repair::force_rows(const Judgement& now, const MovingVertices* moving) const {
  const std::vector<ContactPoint>& points = forces_->system().points();
  const double goal = penalty() ? options_.penalty_goal : options_.goal;
  std::vector<int> chosen;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p].contact >= 0 &&
        now.normal(static_cast<Eigen::Index>(p)) < options_.watched * now.f_min) {
      chosen.push_back(static_cast<int>(p));
    }
  }
  Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()),
                                                    static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    functions(chosen[r], static_cast<Eigen::Index>(r)) = 1;
  }
  const std::vector<VertexPatch> none;
  const std::vector<VertexPatch>& patches = moving ? moving->patches : none;
  std::vector<ForceRow> rows;
  const std::vector<ForceGradient> gradients = force_gradients(*forces_, functions, patches);
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    const double value = (now.normal(chosen[r]) - goal * now.f_min) / now.mean;
    rows.push_back(make_row(value, 1 / now.mean, gradients[r], moving));
  }
  if (watch_floor_ && floor_.status != UnilateralStatus::unsolved) {
    const double value = (now.floor - options_.floor_goal) * now.f_min / now.mean;
    rows.push_back(
        make_row(value, 1 / now.mean, floor_gradient(*forces_, floor_, patches), moving));
  }
  return rows;
}

StepPrices Repair::prices() const {
  StepPrices out;
  out.reach = reach_;
  out.farthest = options_.farthest * parameters_.L;
  const double area = parameters_.L * parameters_.L;
  if (penalty()) {
    // Eq. 3, in units that make a mm of the layout cost one half.
    const double unit = area / (ease * ease);
    out.target = 2 * unit / (area * area);
    out.stiffness = 2 * unit * parameters_.w_tight;
  } else {
    out.target = reluctance / area;
  }
  return out;
}

// Takes the step, back onto the constraints, forces following. False where that fails.
bool Repair::move_to(const LayoutStep& step, const MovingVertices* moving, const Place& from) {
  here_ = from;
  try {
    if (moving) {
      TriangleMesh mesh = from.shape->geometry.tiles.mesh;
      for (int v = 0; v < moving->count(); ++v) {
        mesh.V.row(moving->vertex[v]) += step.vertex_step.row(v);
      }
      here_.shape = make_shape(mesh);
      here_.shape->model.gaps = from.shape->model.gaps;  // collisions found so far
      if (geometry().truncation.unresolved.size() >
          from.shape->geometry.truncation.unresolved.size()) {
        return false;
      }
    }
    const PinBounds& bounds = geometry().pin_bounds;
    here_.state += step.step;
    here_.state.rightCols<6>() =
        here_.state.rightCols<6>().cwiseMax(bounds.lower).cwiseMin(bounds.upper);
    if (!restore_constraints(here_.shape->model, here_.state, 8)) return false;
    forces_->move(geometry(), poses_of(model(), here_.state), insets_of(here_.state), progress_);
    return true;
  } catch (const InvalidInput&) {  // the moving mesh turned over
    return false;
  } catch (const InfeasibleDesign&) {  // a tile lost its back face
    return false;
  } catch (const SolverFailure&) {
    return false;
  }
}

// One accepted step, or false where none lifts the weak forces any more.
bool Repair::take_step(RepairResult& result, Judgement& now, bool with_vertices) {
  const Place from = here_;
  const UnilateralResult floor = floor_;
  MovingVertices chosen;
  if (with_vertices) chosen = moving_vertices(now);
  const MovingVertices* moving = chosen.count() > 0 ? &chosen : nullptr;
  const std::vector<ForceRow> rows = force_rows(now, moving);
  std::vector<int> tiles = tiles_that_matter(model(), rows, 0.02);
  for (const VertexPatch& patch : chosen.patches) {
    for (int k : patch.changed) tiles.push_back(patch.tiles[k]);
  }
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  for (; reach_ > 1e-3; reach_ *= 0.5) {
    last_step_ = least_layout_step(from.shape->model, from.state, rows, tiles, moving, prices());
    if (!move_to(last_step_, moving, from)) continue;
    const Judgement next = judge_here();
    if (!(merit(next) < merit(now) * (1 - 1e-3))) continue;
    LayoutState move = here_.state - from.state;
    move.col(2) *= angle_lever(model());
    double largest = move.cwiseAbs().maxCoeff();
    if (moving) largest = std::max(largest, last_step_.vertex_step.cwiseAbs().maxCoeff());
    now = next;
    result.steps.push_back({now.weak, now.least, now.floor, largest, moving != nullptr, false});
    reach_ = std::min(2 * reach_, options_.reach);
    return true;
  }
  here_ = from;
  floor_ = floor;
  forces_->move(geometry(), poses_of(model(), here_.state), insets_of(here_.state), progress_);
  return false;
}

// Pins of tiles that membranes cut into, and of those next to them, come nearer to their edges.
// False where none can, or the layout has no room for it.
bool Repair::draw_pins_out() {
  const Place from = here_;
  PinBounds& bounds = here_.shape->geometry.pin_bounds;
  const Array6 upper = bounds.upper, caps = caps_;
  bool any = false;
  auto draw_out = [&](int tile, const Touch& touch) {
    for (int t = 0; t < 3; ++t) {
      const int k = inset_index(touch.side, t);
      double& q = here_.state(tile, 3 + k);
      const double cap = std::max(bounds.lower(tile, k) + 0.005, q - 0.1 - 2 * touch.depth);
      if (!(cap < q)) continue;
      caps_(tile, k) = bounds.upper(tile, k) = q = cap;
      any = true;
    }
  };
  for (const Touch& touch : touches_) {
    draw_out(touch.tile, touch);
    for (int t = 0; t < 3; ++t) {
      const int n = geometry().tiles.topology.neighbour(touch.tile, t);
      if (n >= 0) draw_out(n, touch);
    }
  }
  if (!any) return false;
  if (restore_constraints(here_.shape->model, here_.state, 20)) {
    try {
      forces_->move(geometry(), poses_of(model(), here_.state), insets_of(here_.state), progress_);
      return true;
    } catch (const InvalidInput&) {  // the moving mesh turned over
    } catch (const SolverFailure&) {
    }
  }
  here_ = from;
  bounds.upper = upper;
  caps_ = caps;
  forces_->move(geometry(), poses_of(model(), here_.state), insets_of(here_.state), progress_);
  return false;
}

// Near enough to the goals for a fresh mesh to judge.
bool Repair::reached(const Judgement& now) const {
  return !penalty() && now.least >= options_.goal - 0.1 &&
         !(now.floor < options_.floor_goal - 0.05);
}

// Steps until the goals are reached or nothing helps. Returns whether there was one.
bool Repair::improve(RepairResult& result, Judgement& now) {
  bool moved = false, slow = penalty();
  reach_ = options_.reach;
  while (static_cast<int>(result.steps.size()) <= options_.most_steps && !reached(now)) {
    const double before = merit(now);
    const bool with_vertices = slow && parameters_.move_vertices;
    if (take_step(result, now, with_vertices)) {
      moved = true;
      // Vertices join in where poses and pins alone get on slowly.
      slow = penalty() || merit(now) > 0.8 * before;
      tell(now);
    } else if (slow || !parameters_.move_vertices) {
      break;
    } else {
      slow = true;
      reach_ = options_.reach;
    }
  }
  return moved;
}

void Repair::tell(const Judgement& now) const {
  const std::string what = "repair: " + std::to_string(now.weak) + " weak points";
  const double fraction = first_weak_ > 0 ? 1 - static_cast<double>(now.weak) / first_weak_ : 1;
  if (!keep_going(progress_, what, std::max(0.0, fraction))) throw Cancelled();
}

RepairResult Repair::run(const Design& design) {
  RepairResult result;
  result.design = design;
  const Place given = here_;
  Place best = here_;
  Judgement best_judgement;
  bool judged = false;
  try {
    restore_start(result);
    while (true) {
      Judgement now = judge_fresh(result);
      if (!judged) first_weak_ = now.weak;
      result.steps.push_back({now.weak, now.least, now.floor, 0, false, true});
      if (!judged || now.better_than(best_judgement)) {
        best = here_;
        best_judgement = now;
        judged = true;
      }
      tell(now);
      if (now.valid()) {
        result.status = RepairStatus::valid;
        break;
      }
      const bool drawn =
          static_cast<int>(result.steps.size()) <= options_.most_steps && draw_pins_out();
      if (drawn) {
        now = judge_here();
        result.steps.push_back({now.weak, now.least, now.floor, 0, false, false});
      }
      if (!improve(result, now) && !drawn) {
        result.blocked = explain_weak_contacts(geometry().tiles, forces_->system().points(), now,
                                               last_step_.obstacles);
        result.suggestions = suggest_remedies(result.blocked);
        break;
      }
    }
  } catch (const Cancelled&) {
    result.status = RepairStatus::stopped;
  }
  const bool reshaped = best.shape != given.shape;
  if (!judged || (!reshaped && best.state == given.state)) return result;  // bit for bit as given
  const TileMesh& tiles = best.shape->geometry.tiles;
  result.design.T = flat_corners(tiles, poses_of(best.shape->model, best.state));
  result.design.q = insets_of(best.state);
  result.largest_move = std::max((result.design.T - design.T).cwiseAbs().maxCoeff(),
                                 (best.state - given.state).rightCols<6>().cwiseAbs().maxCoeff());
  if (reshaped) {
    if (!design.target) result.design.target = design.mesh;
    result.design.mesh = tiles.mesh;
    result.largest_vertex_move = (tiles.mesh.V - design.mesh.V).rowwise().norm().maxCoeff();
  }
  return result;
}

}  // namespace

RepairResult repair_design(const Design& design, const RepairOptions& options, SolvedDesign* solved,
                           const Progress& progress) {
  return Repair(design, options, solved, progress).run(design);
}

}  // namespace curveups
