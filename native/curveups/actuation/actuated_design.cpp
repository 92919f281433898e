// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/actuated_design.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "curveups/actuation/path_memory.hpp"
#include "curveups/actuation/surplus.hpp"
#include "curveups/contact/settling.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// What two ends may differ by and be the same: of energy, relatively.
constexpr double same_energy = 1e-3;
// What files round poses by.
constexpr double same_pose = 1e-5;

// A path with what is known of its end.
struct Followed {
  ActuationPath path;
  std::vector<PathPhase> phases;
  std::vector<TriangleMesh> shapes;  // as `surface`, of the phases before the last
  PathEnd end;
  TriangleMesh surface;         // of the last frame's fronts
  TileWorld world;              // at its end
  PointLoads* hands = nullptr;  // of the world's energies, without loads
};

// What a path has to say of a phase that goes on from its last frame.
void go_on(ActuationPath& path, ActuationPath phase) {
  if (!path.frames.empty()) count_on(phase.frames, path.frames.back());
  std::move(phase.frames.begin(), phase.frames.end(), std::back_inserter(path.frames));
  path.at_rest = phase.at_rest;
  path.stopped = phase.stopped;
  path.largest_rise = std::max(path.largest_rise, phase.largest_rise);
  path.found_anew += phase.found_anew;
  path.deepest = std::max(path.deepest, phase.deepest);
  path.steps += phase.steps;
  path.iterations += phase.iterations;
  path.factorizations += phase.factorizations;
}

// Of a world with the first of another's bodies: what these do there.
ContactWorld::State only_first(ContactWorld::State state, std::size_t count) {
  state.poses.resize(std::min(count, state.poses.size()));
  state.pairs.erase(std::remove_if(state.pairs.begin(), state.pairs.end(),
                                   [&](const TouchingPair& pair) {
                                     return pair.body[1] >= static_cast<int>(count);
                                   }),
                    state.pairs.end());
  return state;
}

class Actuation {
 public:
  Actuation(const Design& design, const TileBodies& bodies, const SolvedDesign& solved,
            const ActuationOptions& options)
      : design_(design),
        bodies_(bodies),
        solved_(solved),
        options_(options),
        tiles_(bodies.geometry.tiles),
        centres_(tile_centres(tiles_)),
        actuated_(make_world().world->poses()) {
    if (options.memory) take_memory();
    start_ = piece_poses(bodies_,
                         options.start ? frame_poses(tiles_, *options.start) : flat_tiles(bodies_),
                         actuated_);
    phases_ = release_phases(options.release);
    if (phases_.front().surplus) {
      if (options.start || design.parameters.gravity != "off") {
        throw InvalidInput("a piece with its surplus begins flat, without gravity",
                           "choose the release cut, or begin flat and set gravity to off");
      }
      surplus_.emplace(bodies_, static_cast<int>(actuated_.size()));
    }
  }

  ActuatedDesign run() const {
    const Parameters& p = design_.parameters;
    const double own = p.friction_coefficient;
    ActuatedDesign out;
    out.tolerance = hold_tolerance(p);
    out.contacts = static_cast<int>(tiles_.contacts.size());
    out.release = options_.release;
    checkpoint("actuate", 0);
    // From the start and from the target at the design's friction, and the same without friction.
    const bool asked = options_.answers && !options_.start;
    std::vector<Followed> paths(asked && own > 0 ? 4 : 2);
    follow(
        paths,
        [&](int k) { return std::pair(k < 2 ? own : 0.0, &(k % 2 == 0 ? start_ : actuated_)); },
        true);
    Followed& rising = paths[0];
    const Followed& held = paths[1];
    const Followed &loose = paths[paths.size() - 2], &loose_from_target = paths.back();
    const bool ended = stopped(paths);
    if (!ended) compare(paths, held.surface);
    out.path = std::move(rising.path);
    out.end = rising.end;
    out.phases = std::move(rising.phases);
    if (surplus_) {
      out.surplus = {surplus_->anchor_count(), surplus_->box(), surplus_->window()};
    }
    out.from_target = held.end;
    describe(rising.surface, out);
    out.path.stopped = ended;
    if (ended || !held.end.at_rest) return out;
    if (rising.end.at_rest) out.arrives = out.has_arrived(rising.end);
    if (!asked) return out;
    out.sampled = {loose.end};
    if (own > 0) out.sampled.push_back(rising.end);
    out.frictionless_from_target = loose_from_target.end;
    if (loose.end.at_rest && loose_from_target.end.at_rest) {
      const double a = loose.end.energy, b = loose_from_target.end.energy;
      out.trap_distance =
          scan_distances(loose.surface, ClosestPoints(loose_from_target.surface)).mean();
      out.trap = std::abs(a - b) > same_energy * std::abs(b) || out.trap_distance > out.tolerance;
    }
    // Contacts that stay open without friction do so with it.
    const bool may_arrive = loose.end.open_contacts.empty() || !loose.end.at_rest;
    if (own > 0 && may_arrive && !arrives(out, rising.end)) sample_between(held, out);
    for (const PathEnd& end : out.sampled) {
      if (arrives(out, end)) out.reach_friction = end.friction_coefficient;
    }
    if (options_.hands && out.arrives == false) use_hands(rising, held, out);
    return out;
  }

 private:
  void take_memory() {
    memory_ = unpacked(*options_.memory, *make_world().world);
    const Poses& poses = memory_->state.poses;
    const FrameRows rows = frame_rows(tiles_, {poses.begin(), poses.begin() + tiles_.tile_count()});
    if (!options_.start || options_.start->rows() != rows.rows() ||
        (*options_.start - rows).cwiseAbs().maxCoeff() > same_pose) {
      throw InvalidInput("the frame's memory is of other poses",
                         "give a frame of this design, or take its memory out");
    }
  }

  TileWorld make_world() const {
    TileWorld world = make_tile_world(bodies_, solved_, design_.parameters.tile_modulus);
    // What is known of the actuated design alone says nothing of the way there.
    for (PairLoads* corrections : world.corrections) corrections->loads.clear();
    return world;
  }

  // All paths, at once where there are threads. plan(k): the friction, and where bodies begin.
  // remembers: whether the first one's frames have memories.
  // Stopped, it keeps those that have begun: the first at least.
  template <class Plan>
  void follow(std::vector<Followed>& paths, const Plan& plan, bool remembers = false) const {
    const int count = static_cast<int>(paths.size());
    // Worlds first, so that a stop finds all paths begun.
    for (Followed& one : paths) {
      one.world = make_world();
      auto hands = std::make_unique<PointLoads>(std::vector<PointLoad>());
      one.hands = hands.get();
      one.world.world->add(std::move(hands));
    }
    auto follow_one = [&](int k) {
      const auto [friction, begin] = plan(k);
      follow_phases(paths[k], friction, *begin, k == 0, remembers && k == 0);
    };
    try {
      parallel_each(count, follow_one);
    } catch (const Cancelled&) {
      if (paths.front().path.frames.empty()) throw;
      for (Followed& one : paths) one.path.stopped |= one.path.frames.empty();
    }
  }

  // out: with a world for the piece that is cut out, where it ends.
  void follow_phases(Followed& out, double friction, const Poses& begin, bool reports,
                     bool remembers) const {
    const bool rises = &begin == &start_;
    const std::vector<ReleasePhase> phases = rises ? phases_ : release_phases("cut");
    const double share = 1.0 / static_cast<double>(phases.size());
    TileWorld last = std::move(out.world);
    ContactWorld::State state{begin, {}, -1};
    if (phases.front().surplus) {
      state.poses.insert(state.poses.end(), surplus_->flat().begin(), surplus_->flat().end());
    }
    for (std::size_t k = 0; k < phases.size(); ++k) {
      if (phases[k].surplus) {
        const Finishing finishing;
        out.world = make_world();
        surplus_->add_to(*out.world.world, phases[k].held);
      } else {
        std::swap(out.world, last);
      }
      ContactWorld& world = *out.world.world;
      world.restore(only_first(std::move(state), world.bodies().size()));
      world.set_friction(friction);
      PathOptions path = options_.path;
      path.reports = reports;
      path.begun = static_cast<double>(k) * share;
      path.share = share;
      path.most_frames = static_cast<int>(path.most_frames * share);
      if (rises && memory_) path.from = &*memory_;
      path.remembers = remembers && !phases[k].surplus;
      ActuationPath found = follow_path(bodies_, out.world, path);
      const Finishing finishing;
      if (k > 0) out.shapes.push_back(std::move(out.surface));
      out.surface = fitted_surface(tiles_, centres_, world.poses());
      PathPhase phase{std::string(phases[k].name), static_cast<int>(out.path.frames.size()),
                      describe_end(world, tiles_, out.surface, friction, found), 0};
      if (k > 0) phase.removed = out.path.frames.back().energy - found.frames.front().energy;
      go_on(out.path, std::move(found));
      out.end = phase.end;
      out.end.steps = out.path.steps;
      out.end.iterations = out.path.iterations;
      out.end.factorizations = out.path.factorizations;
      out.phases.push_back(std::move(phase));
      if (out.path.stopped) return;
      state = world.state();
    }
  }

  static bool stopped(const std::vector<Followed>& paths) {
    return std::any_of(paths.begin(), paths.end(),
                       [](const Followed& one) { return one.path.stopped; });
  }

  static bool arrives(const ActuatedDesign& out, const PathEnd& end) {
    return end.at_rest && out.has_arrived(end);
  }

  static void compare(std::vector<Followed>& paths, const TriangleMesh& shape) {
    const Finishing finishing;
    const ClosestPoints surface(shape);
    for (Followed& one : paths) {
      one.end.shortfall = scan_distances(one.surface, surface).mean();
      for (std::size_t k = 0; k < one.phases.size(); ++k) {
        one.phases[k].end.shortfall = k < one.shapes.size()
                                          ? scan_distances(one.shapes[k], surface).mean()
                                          : one.end.shortfall;
      }
    }
  }

  void describe(const TriangleMesh& surface, ActuatedDesign& out) const {
    const Finishing finishing;
    for (const PathFrame& frame : out.path.frames) {
      out.frames.push_back(frame_rows(tiles_, frame.poses));
    }
    const Eigen::VectorXd far = scan_distances(surface, ClosestPoints(design_.mesh));
    out.corners = surface.V;
    out.deviation = triangle_means(far);
  }

  void use_hands(Followed& jammed, const Followed& held, ActuatedDesign& out) const {
    try {
      out.hands = bring_home(bodies_, jammed.world, *jammed.hands,
                             {held.world.world->poses(), held.surface, out.tolerance},
                             design_.parameters.friction_coefficient, out.path.frames.back(),
                             options_.touch);
      for (const PathFrame& frame : out.hands->frames) {
        out.hand_frames.push_back(frame_rows(tiles_, frame.poses));
      }
    } catch (const Cancelled&) {
      out.path.stopped = true;
    }
  }

  // At quarters of the design's own friction.
  void sample_between(const Followed& held, ActuatedDesign& out) const {
    std::vector<Followed> paths(3);
    follow(paths, [&](int k) {
      return std::pair(0.25 * (k + 1) * design_.parameters.friction_coefficient, &start_);
    });
    if (stopped(paths)) return;
    compare(paths, held.surface);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      out.sampled.insert(out.sampled.end() - 1, paths[k].end);
    }
  }

  const Design& design_;
  const TileBodies& bodies_;
  const SolvedDesign& solved_;
  const ActuationOptions& options_;
  const TileMesh& tiles_;
  Points3 centres_;
  Poses actuated_, start_;
  std::optional<ContactWorld::PathState> memory_;
  std::vector<ReleasePhase> phases_;
  std::optional<Surplus> surplus_;
};

}  // namespace

ActuatedDesign actuate_design(const Design& design, const ActuationOptions& options,
                              const Progress& progress) {
  if (design.parameters.gravity == "held") {
    throw InvalidInput("gravity=held holds tiles where they are when actuated",
                       "set gravity to off or resting: a piece that rises is held nowhere");
  }
  check_touch(options.touch, static_cast<int>(design.mesh.F.rows()));
  if (!options.touch.tiles.empty() && (!options.hands || !options.answers || options.start)) {
    throw InvalidInput("tiles are pressed by hands, where a path from flat ends",
                       "begin flat, with answers and hands, or name no tiles");
  }
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  SolvedDesign solved = solve_design(bodies.geometry, design, progress);
  return Actuation(design, bodies, solved, options).run();
}

}  // namespace curveups
