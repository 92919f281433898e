// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/path.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/actuation/flat_piece.hpp"
#include "curveups/actuation/path_memory.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

// mm: times the material's modulus, how stiff two tiles are that touch. About what their walls are
// as layers, and what a corner is that is rounded by as much.
constexpr double contact_width = 0.25;

// A path whose energy falls by less than this part in so many steps, and that is not at rest, goes
// round in circles: tips of bumps that slide off walls and onto them again.
constexpr int stalled_steps = 60;
constexpr double stalled_part = 1e-4;
// The same under weight, which is little beside what membranes store: a piece that settles on its
// table is no circle.
constexpr double stalled_part_resting = 1e-5;

Pace pace_of(const Parameters& parameters) {
  Pace pace;
  pace.step_limit = parameters.L / 7.5;
  // What a step may meet: could_pass holds what comes from further.
  pace.search.reach = std::max(1.5 * pace.step_limit, 0.5 * parameters.H_body);
  pace.search.pair_stiffness = contact_width * parameters.tile_modulus;
  pace.search.face_margin = 0.01;
  return pace;
}

double mean_way(const Poses& from, const Poses& to, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += (to[i].t - from[i].t).norm();
  return sum / std::max(count, 1);
}

// Half as many, where there are more than `most`, evenly by the way of the tiles; of those near one
// another, one with a memory.
void thin_out(std::vector<PathFrame>& frames, int most) {
  if (static_cast<int>(frames.size()) <= most) return;
  most = std::max(most / 2, 2);
  const double whole = frames.back().moved;
  std::vector<PathFrame> kept;
  for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
    if (frames[k].moved * (most - 1) >= whole * static_cast<double>(kept.size())) {
      kept.push_back(std::move(frames[k]));
    } else if (kept.size() > 1 && kept.back().memory.size() == 0 && frames[k].memory.size() > 0) {
      kept.back() = std::move(frames[k]);
    }
  }
  kept.push_back(std::move(frames.back()));
  frames = std::move(kept);
}

// Leaves memories of so many numbers: of the first frame, the last, and between them evenly by the
// way of the tiles.
void forget_some(std::vector<PathFrame>& frames, Eigen::Index most) {
  std::vector<PathFrame*> remembering;
  Eigen::Index numbers = 0;
  for (PathFrame& frame : frames) {
    if (frame.memory.size() == 0) continue;
    remembering.push_back(&frame);
    numbers += frame.memory.size();
  }
  while (numbers > most && remembering.size() > 2) {
    std::size_t least = 1;
    auto gap = [&](std::size_t k) { return remembering[k + 1]->moved - remembering[k - 1]->moved; };
    for (std::size_t k = 2; k + 1 < remembering.size(); ++k) {
      if (gap(k) < gap(least)) least = k;
    }
    numbers -= remembering[least]->memory.size();
    remembering[least]->memory.resize(0);
    remembering.erase(remembering.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

}  // namespace

void count_on(std::vector<PathFrame>& frames, const PathFrame& last) {
  for (PathFrame& frame : frames) {
    frame.time += last.time;
    frame.friction += last.friction;
    frame.hands += last.hands;
    frame.moved += last.moved;
  }
}

PathFollower::PathFollower(const TileBodies& bodies, TileWorld& world, const PathOptions& options,
                           const PointLoads* hands)
    : bodies_(bodies), world_(world), options_(options), hands_(hands) {
  world.world->begin_path(pace_of(bodies.parameters));
  if (options.from) world.world->resume(*options.from);
  now_.energy = world.world->energy() - pushing();
  keep();
}

void PathFollower::keep() {
  now_.poses = world_.world->poses();
  now_.stretch = mean_stretch(bodies_, now_.poses);
  if (options_.remembers) now_.memory = packed(world_.world->path_state());
  path_.frames.push_back(now_);
  forget_some(path_.frames, options_.most_remembered);
}

StepReport PathFollower::step() {
  ContactWorld& moving = *world_.world;
  const Poses before = moving.poses();
  const double pushed = pushing();
  const StepReport step = moving.advance();
  path_.iterations += step.iterations;
  path_.factorizations += step.factorizations;
  path_.at_rest = step.at_rest;
  if (step.at_rest) return step;
  ++path_.steps;
  path_.largest_rise = std::max(path_.largest_rise, step.energy - step.before);
  path_.found_anew += std::abs(step.before - pushed - now_.energy);
  for (const TouchForce& touch : moving.forces()) {
    path_.deepest = std::max(path_.deepest, -touch.gap);
  }
  now_.time += 1 / step.weight;
  now_.energy = step.energy - pushing();
  now_.friction += step.friction;
  now_.hands += pushed - pushing();
  now_.moved += mean_way(before, moving.poses(), world_.tile_count);
  keep();
  thin_out(path_.frames, 8 * options_.most_frames);
  return step;
}

ActuationPath PathFollower::take() {
  thin_out(path_.frames, 2 * options_.most_frames);
  return std::move(path_);
}

ActuationPath follow_path(const TileBodies& bodies, TileWorld& world, const PathOptions& options) {
  PathFollower follower(bodies, world, options);
  const ActuationPath& path = follower.path();
  std::vector<double> energies;  // before each step
  bool stopped = false;
  const double least_part =
      bodies.parameters.gravity == "resting" ? stalled_part_resting : stalled_part;
  try {
    while (path.steps < options.max_steps) {
      const int earlier = path.steps - stalled_steps;
      const double now = follower.energy();
      if (earlier > 0 && energies[earlier] - now < least_part * std::abs(now)) break;
      energies.push_back(now);
      if (follower.step().at_rest) break;
      if (options.reports) {
        checkpoint("actuate", options.begun + options.share * path.steps / (path.steps + 50.0));
      }
    }
  } catch (const Cancelled&) {
    stopped = true;
  }
  ActuationPath out = follower.take();
  out.stopped = stopped;
  out.at_rest = out.at_rest && !stopped;
  return out;
}

}  // namespace curveups
