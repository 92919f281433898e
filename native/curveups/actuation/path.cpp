// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

// mm: stiffness between two tiles that touch, over the material's modulus; about that of their
// walls as layers, and of a corner that is rounded by as much.
constexpr double contact_width = 0.25;

// A path that is not at rest, and whose energy falls by less than this part in so many steps, goes
// round in circles: tips of bumps slide off walls and onto them again.
constexpr int stalled_steps = 60;
constexpr double stalled_part = 1e-4;

// Relaxing: most steps, most solutions of finite elements, and the element_change that ends them.
constexpr int relaxing_steps = 60, most_rounds = 3;
constexpr double element_tolerance = 0.01;

// Steps of a tap: without friction, and with it.
constexpr int most_taps = 40, free_steps = 6, held_steps = 3;
constexpr double weak_tap = 1e-4;       // part of the energy
constexpr int pressed_steps = 40;       // without friction, and as many with it
constexpr double press_of_normal = 4;   // force on a tile over the contacts' mean normal force
constexpr double former_reach = 0.013;  // over L: within it the force fades
constexpr int few_frames = 15;          // of shaking and of pressing
constexpr const char* doing[] = {"relaxing", "releasing", "shaking", "pressing"};  // by load case

Pace pace_of(const Parameters& parameters) {
  Pace pace;
  pace.step_limit = parameters.L / 7.5;
  // Bodies that a step may meet; could_pass stops those from further away.
  pace.search.reach = std::max(1.5 * pace.step_limit, 0.5 * parameters.H_body);
  pace.search.pair_stiffness = contact_width * tile_modulus;
  pace.search.face_margin = 0.01;
  return pace;
}

double mean_distance(const Poses& from, const Poses& to, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += (to[i].t - from[i].t).norm();
  return sum / std::max(count, 1);
}

// Thins the frames from `first` on to about half of `most` where there are more, evenly by the
// motion of the tiles.
void thin_out(std::vector<PathFrame>& frames, std::size_t first, int most) {
  if (frames.size() <= first + most) return;
  const double begin = frames[first].moved, whole = frames.back().moved - begin;
  const int wanted = std::max(most / 2 - 1, 1);
  std::size_t kept = first;
  for (std::size_t k = first; k + 1 < frames.size(); ++k) {
    if ((frames[k].moved - begin) * wanted < whole * static_cast<double>(kept - first)) continue;
    if (kept != k) frames[kept] = std::move(frames[k]);
    ++kept;
  }
  frames[kept] = std::move(frames.back());
  frames.resize(kept + 1);
}

}  // namespace

// Presses tiles towards their places: a force that fades within `reach` of a place.
class Path::Former : public MotionEnergy {
 public:
  Points3 places;    // centres of the tiles
  double force = 0;  // N on a tile that is far from its place
  double reach = 0;  // mm

  void couple(std::vector<Coupling>&) const override {}
  double value(const Poses& poses) const override {
    double sum = 0;
    for (Eigen::Index i = 0; force > 0 && i < places.rows(); ++i) {
      sum += force * (std::hypot((poses[i].t - places.row(i).transpose()).norm(), reach) - reach);
    }
    return sum;
  }
  double derivatives(const Poses& poses, double, Motions& gradient,
                     const MotionHessian* hessian) const override {
    for (int i = 0; force > 0 && i < places.rows(); ++i) {
      const Vec3 way = poses[i].t - places.row(i).transpose();
      const double length = std::hypot(way.norm(), reach);
      MotionDerivatives<1> out;
      out.gradient.head<3>() = force / length * way;
      out.hessian.topLeftCorner<3, 3>() =
          force / length *
          (Eigen::Matrix3d::Identity() - way * way.transpose() / (length * length));
      out.add_to({i}, gradient, hessian, 0);
    }
    return value(poses);
  }
};

Path::Path(const TileBodies& bodies, TileWorld& world, const TriangleMesh& target, double friction,
           const PathOptions& options)
    : bodies_(bodies),
      tiles_(bodies.geometry.tiles),
      piece_(world),
      world_(*world.world),
      target_(target),
      options_(options),
      friction_(friction),
      centres_(tile_centres(tiles_)),
      actuated_(tile_poses()),
      pieces_(pieces_of(tiles_)) {
  auto former = std::make_unique<Former>();
  former->places.resize(tiles_.tile_count(), 3);
  former->reach = former_reach * bodies.parameters.L;
  former_ = former.get();
  world_.add(std::move(former));
}

Poses Path::tile_poses() const {
  const Poses& all = world_.poses();
  return {all.begin(), all.begin() + tiles_.tile_count()};
}

RestState Path::relax(SolvedDesign* solved) {
  state_ = {};
  world_.set_friction(0);
  world_.begin_path(Pace::relaxing(world_.pace()));
  for (int round = 0; round < most_rounds; ++round) {
    const StepReport last = world_.settle(relaxing_steps, [&](const StepReport&) {
      ++state_.steps;
      checkpoint("relaxing", state_.steps / (state_.steps + 20.0) / 4);
      return false;
    });
    state_.at_rest = last.at_rest;
    if (!solved || !state_.at_rest) break;
    state_.element_change = piece_.solve_elements(*solved, element_tolerance);
    if (state_.element_change <= element_tolerance) break;
  }
  state_.energy = world_.energy();
  describe();
  return state_;
}

RestState Path::release() {
  for (PairLoads* corrections : piece_.corrections) corrections->loads.clear();
  world_.set_poses(piece_poses(piece_, flat_tiles(bodies_)));
  begin(LoadCase::released);
  world_.set_friction(friction_);
  run(options_.max_steps);
  return finish(options_.most_frames);
}

RestState Path::shake() {
  begin(LoadCase::shaken);
  for (int weak = 0; state_.taps < most_taps && weak < 2; ++state_.taps) {
    const double before = now_.energy;
    world_.set_friction(0);
    run(free_steps);
    world_.set_friction(friction_);
    run(held_steps);
    weak = before - now_.energy < weak_tap * std::abs(before) ? weak + 1 : 0;
  }
  run(options_.max_steps);
  return finish(few_frames);
}

RestState Path::press() {
  const double force = press_of_normal * state_.push;
  begin(LoadCase::pressed);
  state_.force = former_->force = force;
  for (double friction : {0.0, friction_}) {
    world_.set_friction(friction);
    run(pressed_steps);
  }
  former_->force = 0;
  run(options_.max_steps);
  return finish(few_frames);
}

void Path::begin(LoadCase load) {
  world_.begin_path(pace_of(bodies_.parameters));
  state_ = {};
  now_.load = load;
  now_.energy = world_.energy();
  first_frame_ = frames_.size();
  if (!frames_.empty()) return;
  now_.tiles = frame_rows(tiles_, tile_poses());
  now_.stretch = mean_stretch(piece_, bodies_);
  frames_.push_back(now_);
}

// Takes an implicit Euler step; true where the piece is at rest and nothing moved.
bool Path::step() {
  if (former_->force > 0) fit_former();
  const Poses before = world_.poses();
  const StepReport report = world_.step();
  state_.at_rest = report.at_rest;
  if (report.at_rest) return true;
  ++state_.steps;
  now_.time += 1 / report.weight;
  now_.energy = report.energy - former_->value(world_.poses());
  now_.friction += report.friction;
  now_.moved += mean_distance(before, world_.poses(), tiles_.tile_count());
  now_.tiles = frame_rows(tiles_, tile_poses());
  now_.stretch = mean_stretch(piece_, bodies_);
  frames_.push_back(now_);
  thin_out(frames_, first_frame_, 4 * options_.most_frames);
  return false;
}

// Steps until the piece is at rest or goes round in circles.
void Path::run(int most_steps) {
  std::vector<double> energies;  // before each step
  for (int k = 0; k < most_steps; ++k) {
    if (k > stalled_steps &&
        energies[k - stalled_steps] - now_.energy < stalled_part * std::abs(now_.energy)) {
      return;
    }
    energies.push_back(now_.energy);
    if (step()) return;
    const int load = static_cast<int>(now_.load);
    checkpoint(doing[load], (load + state_.steps / (state_.steps + 50.0)) / 4);
  }
}

// Lays the former under each piece as that stands.
void Path::fit_former() {
  for (const std::vector<int>& own : pieces_) {
    const Eigen::Index count = static_cast<Eigen::Index>(own.size());
    Points3 from(count, 3), to(count, 3);
    for (Eigen::Index k = 0; k < count; ++k) {
      from.row(k) = actuated_[own[k]].t.transpose();
      to.row(k) = world_.poses()[own[k]].t.transpose();
    }
    const RigidMotion fit = best_fit(from, to);
    for (int i : own) former_->places.row(i) = fit(actuated_[i].t).transpose();
  }
}

// Ends a load case of the path.
RestState Path::finish(int most_frames) {
  thin_out(frames_, first_frame_, 2 * most_frames);
  state_.last_frame = static_cast<int>(frames_.size()) - 1;
  state_.energy = now_.energy;
  describe();
  return state_;
}

// Describes the piece as it stands.
void Path::describe() {
  const Finishing finishing;
  state_.tiles = frame_rows(tiles_, tile_poses());
  const TriangleMesh surface = fitted_surface(tiles_, centres_, world_.poses());
  const Eigen::VectorXd far = scan_distances(surface, ClosestPoints(target_));
  state_.scan = describe_scan(far, surface, target_);
  state_.deviation = triangle_means(far);
  const Eigen::VectorXd pushes = contact_pushes(tiles_, world_);
  if (pushes.size() > 0) state_.push = pushes.mean();
  for (Eigen::Index k = 0; k < pushes.size(); ++k) {
    if (pushes(k) == 0) state_.open_contacts.push_back(tiles_.contacts[k].tile);
  }
}

}  // namespace curveups
