// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/actuated_design.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/actuation/path_memory.hpp"
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
  PathEnd end;
  TriangleMesh surface;         // of the last frame's fronts
  TileWorld world;              // at its end
  PointLoads* hands = nullptr;  // of the world's energies, without loads
};

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
  }

  ActuatedDesign run() const {
    const Parameters& p = design_.parameters;
    const double own = p.friction_coefficient;
    ActuatedDesign out;
    out.tolerance = p.hold_tolerance > 0 ? p.hold_tolerance : 0.01 * p.L;
    out.contacts = static_cast<int>(tiles_.contacts.size());
    checkpoint("actuate", 0);
    // From the start and from the target at the design's friction, and the same without friction.
    const bool asked = options_.answers && !options_.start;
    std::vector<Followed> paths(asked && own > 0 ? 4 : 2);
    follow(paths,
           [&](int k) { return std::pair(k < 2 ? own : 0.0, &(k % 2 == 0 ? start_ : actuated_)); });
    Followed& rising = paths[0];
    const Followed& held = paths[1];
    const Followed &loose = paths[paths.size() - 2], &loose_from_target = paths.back();
    const bool ended = stopped(paths);
    if (!ended) compare(paths, held.surface);
    out.path = std::move(rising.path);
    out.end = rising.end;
    out.memory = packed(rising.world.world->path_state());
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
    if (arrives(out, loose.end) && !arrives(out, rising.end)) sample_between(held, out);
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
  // Stopped, it keeps those that have begun: the first at least.
  template <class Plan>
  void follow(std::vector<Followed>& paths, const Plan& plan) const {
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
      Followed& out = paths[k];
      TileWorld& world = out.world;
      world.world->set_poses(*begin);
      world.world->set_friction(friction);
      PathOptions path = options_.path;
      path.reports = k == 0;
      if (begin == &start_ && memory_) path.from = &*memory_;
      out.path = follow_path(bodies_, world, path);
      const Finishing finishing;
      out.surface = fitted_surface(tiles_, centres_, world.world->poses());
      PathEnd& end = out.end;
      end = describe_end(*world.world, tiles_, out.surface, design_.mesh);
      end.friction_coefficient = friction;
      end.at_rest = out.path.at_rest;
      end.steps = out.path.steps;
      end.iterations = out.path.iterations;
      end.factorizations = out.path.factorizations;
    };
    try {
      parallel_each(count, follow_one);
    } catch (const Cancelled&) {
      if (paths.front().path.frames.empty()) throw;
      for (Followed& one : paths) one.path.stopped |= one.path.frames.empty();
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
    for (Followed& one : paths) one.end.shortfall = scan_distances(one.surface, surface).mean();
  }

  void describe(const TriangleMesh& surface, ActuatedDesign& out) const {
    const Finishing finishing;
    for (const PathFrame& frame : out.path.frames) {
      out.frames.push_back(frame_rows(tiles_, frame.poses));
    }
    const Eigen::VectorXd far = scan_distances(surface, ClosestPoints(design_.mesh));
    out.corners = surface.V;
    out.deviation.resize(tiles_.tile_count());
    for (int i = 0; i < tiles_.tile_count(); ++i) {
      out.deviation(i) = far.segment<scan_samples>(scan_samples * i).mean();
    }
  }

  void use_hands(Followed& jammed, const Followed& held, ActuatedDesign& out) const {
    try {
      out.hands = bring_home(bodies_, jammed.world, *jammed.hands,
                             {held.world.world->poses(), held.surface, out.tolerance},
                             design_.parameters.friction_coefficient, out.path.frames.back());
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
};

}  // namespace

ActuatedDesign actuate_design(const Design& design, SolutionStore* store,
                              const ActuationOptions& options, const Progress& progress) {
  if (design.parameters.gravity == "held") {
    throw InvalidInput("gravity=held holds tiles where they are when actuated",
                       "set gravity to off or resting: a piece that rises is held nowhere");
  }
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  SolvedDesign solved = take_or_solve(store, bodies.geometry, design, progress);
  ActuatedDesign out = Actuation(design, bodies, solved, options).run();
  if (store) store->put(std::move(solved));
  return out;
}

}  // namespace curveups
