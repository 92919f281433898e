// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/hands.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {
namespace {

constexpr int most_taps = 40, steps_a_tap = 12;
// Taps that lower the energy by less than this part do nothing any more.
constexpr double weak_tap = 1e-4;
constexpr int shaken_steps = 40, pressed_steps = 40, free_steps = 100;
// Times the mean normal force of a contact: what is tried on all tiles, until it does.
constexpr double forces[] = {4, 2, 1, 0.5};
constexpr double usual_part = 2;    // the same, on tiles that are chosen
constexpr double most_force = 1e6;  // N: far more than hands have, far less than numbers bear
constexpr int most_halvings = 4;    // of the force, once the tiles are found

// The next lower one of 1, 2, 5, 10, ...
double round_number(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)));
  const double part = value / unit;
  return (part >= 5 ? 5 : part >= 2 ? 2 : 1) * unit;
}

class HandSearch {
 public:
  HandSearch(const TileBodies& bodies, TileWorld& world, PointLoads& hands, const Home& home,
             double friction, const PathFrame& first, const ChosenTouch& chosen)
      : bodies_(bodies),
        tiles_(bodies.geometry.tiles),
        built_(world),
        hands_(hands),
        world_(*world.world),
        home_(home),
        first_(first),
        chosen_(chosen),
        shape_(home.shape),
        friction_(friction),
        centres_(tile_centres(tiles_)),
        reach_(bodies.parameters.L / 7.5) {
    const std::vector<int> piece = pieces_of_faces(tiles_.topology, tiles_.cut);
    for (int i = 0; i < tiles_.tile_count(); ++i) {
      if (piece[i] >= static_cast<int>(pieces_.size())) pieces_.resize(piece[i] + 1);
      pieces_[piece[i]].push_back(i);
    }
  }

  Hands run() {
    shake();
    const Homecoming before = reached(out_.shaken);
    out_.end = out_.shaken;
    out_.reached = before;
    if (before == Homecoming::home) return std::move(out_);
    remember_jammed();
    choose_order();
    if (!chosen_.tiles.empty()) {
      press_chosen();
      return std::move(out_);
    }
    const int all = static_cast<int>(order_.size());
    double best = out_.end.shortfall;
    for (const double part : forces) {
      const double force = force_of(part);
      if (force == force_) continue;  // rounded to the one before
      force_ = force;
      Trial trial = press(all);
      if (trial.reached > before) {
        fewest(all, trial);
        return std::move(out_);
      }
      if (trial.end.at_rest && trial.end.shortfall < best) {
        best = trial.end.shortfall;
        out_.end = trial.end;
      }
    }
    return std::move(out_);
  }

 private:
  struct Trial {
    Homecoming reached;
    PathEnd end;
    std::vector<PathFrame> frames;
  };

  Homecoming reached(const PathEnd& end) const {
    if (!end.at_rest || end.shortfall > home_.tolerance) return Homecoming::none;
    return end.open_contacts.empty() ? Homecoming::home : Homecoming::shape;
  }

  PathEnd end_of(const ActuationPath& path) const {
    const Finishing finishing;
    const TriangleMesh surface = fitted_surface(tiles_, centres_, world_.poses());
    PathEnd end = describe_end(world_, tiles_, surface, friction_, path);
    end.shortfall = scan_distances(surface, shape_).mean();
    return end;
  }

  bool come_to_rest(PathFollower& follower, int most) {
    for (int k = 0; k < most; ++k) {
      if (follower.step().at_rest) return true;
    }
    return false;
  }

  // Frames but for the first, which is the last of what they go on from.
  std::vector<PathFrame> take(ActuationPath path, const PathFrame& from) {
    out_.largest_rise = std::max(out_.largest_rise, path.largest_rise);
    std::vector<PathFrame> frames(std::next(path.frames.begin()), path.frames.end());
    count_on(frames, from);
    return frames;
  }

  void shake() {
    PathFollower follower(bodies_, built_, options(), &hands_);
    double before = follower.energy();
    for (int weak = 0; out_.taps < most_taps && weak < 2;) {
      world_.set_friction(0);
      follower.step();
      world_.set_friction(friction_);
      ++out_.taps;
      come_to_rest(follower, steps_a_tap);
      const double now = follower.energy();
      weak = before - now < weak_tap * std::abs(before) ? weak + 1 : 0;
      before = now;
      checkpoint("shaking", static_cast<double>(out_.taps) / most_taps);
    }
    come_to_rest(follower, free_steps);
    out_.shaken = end_of(follower.path());
    out_.frames = take(follower.take(), first_);
    out_.shaking_frames = static_cast<int>(out_.frames.size());
  }

  static PathOptions options() {
    PathOptions out;
    out.most_frames = 15;
    return out;
  }

  // How far each tile is from its place, as it stands; fits: of each piece, from home to here.
  Points3 ways_home(std::vector<RigidMotion>* fits = nullptr) const {
    Points3 ways(tiles_.tile_count(), 3);
    for (const std::vector<int>& own : pieces_) {
      Points3 from(own.size(), 3), to(own.size(), 3);
      for (std::size_t k = 0; k < own.size(); ++k) {
        from.row(k) = home_.poses[own[k]].t.transpose();
        to.row(k) = world_.poses()[own[k]].t.transpose();
      }
      const RigidMotion fit = best_fit(from, to);
      for (std::size_t k = 0; k < own.size(); ++k) {
        ways.row(own[k]) = fit(from.row(k).transpose()).transpose() - to.row(k);
      }
      if (fits) fits->push_back(fit);
    }
    return ways;
  }

  // Which tiles to press first: those that are far from their places, and far from one another.
  void choose_order() {
    const Points3 ways = ways_home();
    const double apart = 3 * bodies_.parameters.L;
    Eigen::VectorXd worth = ways.rowwise().norm();
    std::vector<char> is_left(worth.size(), 1);
    for (Eigen::Index k = 0; k < worth.size(); ++k) {
      int best = -1;
      for (int i = 0; i < worth.size(); ++i) {
        if (is_left[i] && (best < 0 || worth(i) > worth(best))) best = i;
      }
      is_left[best] = 0;
      order_.push_back(best);
      for (int i = 0; i < worth.size(); ++i) {
        const double near = (home_.poses[i].t - home_.poses[best].t).norm() / apart;
        if (near < 1) worth(i) *= 0.02 + 0.98 * near;
      }
    }
  }

  // A trial begins as a path does, and ends alike whatever was tried before.
  void remember_jammed() {
    jammed_ = world_.path_state();
    jammed_.convex = 1;
    jammed_.state.weight = -1;
  }

  void press_chosen() {
    const std::set<int> chosen(chosen_.tiles.begin(), chosen_.tiles.end());
    std::stable_partition(order_.begin(), order_.end(), [&](int i) { return chosen.count(i) > 0; });
    const int count = static_cast<int>(chosen.size());
    force_ = chosen_.force.value_or(force_of(usual_part));
    keep(count, press(count, "pressing"));
  }

  // part: of the mean normal force of a contact.
  double force_of(double part) const {
    return round_number(part * std::max(out_.shaken.push, 1e-3));
  }

  // Loads of this moment on the first tiles of the order.
  void push(int count) {
    const Points3 ways = ways_home();
    Points3 force = Points3::Zero(tiles_.tile_count(), 3);
    for (int k = 0; k < count; ++k) {
      const auto way = ways.row(order_[k]);
      force.row(order_[k]) = force_ * way / std::max(way.norm(), reach_);
    }
    std::vector<PointLoad>& loads = hands_.loads;
    loads.clear();
    for (const std::vector<int>& own : pieces_) {
      Vec3 middle = Vec3::Zero(), sum = Vec3::Zero(), torque = Vec3::Zero();
      for (int i : own) {
        middle += world_.poses()[i].t / static_cast<double>(own.size());
        sum += force.row(i).transpose() / static_cast<double>(own.size());
      }
      Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
      for (int i : own) {
        const Vec3 arm = world_.poses()[i].t - middle;
        torque += arm.cross(Vec3(force.row(i).transpose()));
        inertia += arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
      }
      const Vec3 turn = inertia.completeOrthogonalDecomposition().solve(torque);
      for (int i : own) {
        const Vec3 arm = world_.poses()[i].t - middle;
        loads.push_back({i, Vec3::Zero(), Vec3(force.row(i).transpose()) - sum - turn.cross(arm)});
      }
    }
  }

  Trial press(int count, const char* doing = "looking for touches") {
    checkpoint(doing, out_.tried / (out_.tried + 8.0));
    ++out_.tried;
    out_.largest_force = std::max(out_.largest_force, force_);
    Trial trial;
    PathOptions path = options();
    path.from = &jammed_;
    PathFollower follower(bodies_, built_, path, &hands_);
    for (const auto& [friction, most] :
         {std::pair(0.0, shaken_steps), std::pair(friction_, pressed_steps)}) {
      world_.set_friction(friction);
      for (int k = 0; k < most; ++k) {
        push(count);
        if (follower.step().at_rest) break;
      }
    }
    hands_.loads.clear();
    come_to_rest(follower, free_steps);
    trial.end = end_of(follower.path());
    trial.reached = reached(trial.end);
    trial.frames = take(follower.take(), out_.frames.empty() ? first_ : out_.frames.back());
    return trial;
  }

  // Of tiles that bring it where `best` ends: fewer, by halving the range, then with less force.
  void fewest(int count, Trial best) {
    const Homecoming wanted = best.reached;
    for (int too_few = 0; count - too_few > std::max(1, count / 8);) {
      const int fewer = (count + too_few) / 2;
      Trial trial = press(fewer);
      if (trial.reached >= wanted) {
        count = fewer;
        best = std::move(trial);
      } else {
        too_few = fewer;
      }
    }
    for (int k = 0; k < most_halvings; ++k) {
      const double before = force_;
      force_ = round_number(0.5 * force_);
      Trial trial = press(count);
      if (trial.reached < wanted) {
        force_ = before;
        break;
      }
      best = std::move(trial);
    }
    keep(count, std::move(best));
  }

  // What hands do on the first tiles of the order, as the answer.
  void keep(int count, Trial trial) {
    out_.end = trial.end;
    out_.reached = trial.reached;
    std::move(trial.frames.begin(), trial.frames.end(), std::back_inserter(out_.frames));
    world_.restore(jammed_.state);
    describe_touches(count);
  }

  void describe_touches(int count) {
    std::vector<RigidMotion> fits;
    const Points3 ways = ways_home(&fits);
    std::vector<int> piece_of(tiles_.tile_count());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (int i : pieces_[p]) piece_of[i] = static_cast<int>(p);
    }
    for (int k = 0; k < count; ++k) {
      const int i = order_[k];
      const Vec3 direction =
          (fits[piece_of[i]].R.transpose() * ways.row(i).transpose()).normalized();
      const auto group =
          std::find_if(out_.touches.begin(), out_.touches.end(), [&](const HandTouch& touch) {
            const int seed = touch.tiles.front();
            return touch.direction.dot(direction) > 0.866 && piece_of[seed] == piece_of[i] &&
                   (home_.poses[seed].t - home_.poses[i].t).norm() < 2 * bodies_.parameters.L;
          });
      if (group == out_.touches.end()) {
        out_.touches.push_back({{i}, direction, 0, force_});
      } else {
        group->tiles.push_back(i);
      }
    }
    for (HandTouch& touch : out_.touches) {
      std::sort(touch.tiles.begin(), touch.tiles.end());
      Vec3 sum = Vec3::Zero(), normal = Vec3::Zero();
      for (int i : touch.tiles) {
        sum += fits[piece_of[i]].R.transpose() * ways.row(i).transpose().normalized();
        normal += tiles_.normal(i);
      }
      touch.direction = sum.normalized();
      touch.outward = touch.direction.dot(normal.normalized());
    }
  }

  const TileBodies& bodies_;
  const TileMesh& tiles_;
  TileWorld& built_;
  PointLoads& hands_;
  ContactWorld& world_;
  const Home& home_;
  const PathFrame& first_;
  const ChosenTouch& chosen_;
  ClosestPoints shape_;
  double friction_;
  Points3 centres_;
  double reach_;  // mm: over the last part of the way the force fades
  std::vector<std::vector<int>> pieces_;
  std::vector<int> order_;
  ContactWorld::PathState jammed_;
  double force_ = 0;
  Hands out_;
};

}  // namespace

void check_touch(const ChosenTouch& chosen, int tile_count) {
  std::vector<char> is_chosen(tile_count, 0);
  for (int tile : chosen.tiles) {
    if (tile < 0 || tile >= tile_count) {
      throw InvalidInput("there is no tile " + std::to_string(tile),
                         "press tiles from 0 to " + std::to_string(tile_count - 1));
    }
    if (std::exchange(is_chosen[tile], 1)) {
      throw InvalidInput("a tile is pressed twice", "name it once", {tile});
    }
  }
  if (!chosen.force) return;
  if (chosen.tiles.empty()) throw InvalidInput("a force presses no tile", "name the tiles");
  if (!(*chosen.force > 0 && *chosen.force <= most_force)) {
    throw InvalidInput("hands press with a force above 0 N, up to 1e6 N", "give another force");
  }
}

Hands bring_home(const TileBodies& bodies, TileWorld& world, PointLoads& hands, const Home& home,
                 double friction, const PathFrame& first, const ChosenTouch& chosen) {
  return HandSearch(bodies, world, hands, home, friction, first, chosen).run();
}

}  // namespace curveups
