// SPDX-License-Identifier: LGPL-2.1-or-later
// The path of a piece from any poses of its tiles to where it comes to rest. It is overdamped, as
// membranes are slow and tiles light: neighbours resist one another with a drag of 1 N s / mm
// (contact/drag), and friction holds them as Coulomb's law says (ContactWorld::advance). Stored
// energy falls by what drag and friction take. All tiles that touch are equally stiff, so that
// corners do not sink into one another.
#pragma once

#include "curveups/contact/tile_world.hpp"

namespace curveups {

struct PathOptions {
  int max_steps = 1000;
  int most_frames = 60;         // kept, about, evenly by how far tiles move, with both ends
  bool reports = true;          // how far it is; else it can only be stopped
  double begun = 0, share = 1;  // of what it reports: where it begins, and its part of the whole
  const ContactWorld::PathState* from = nullptr;  // where an earlier path stood; it outlives this
  bool remembers = false;                         // whether frames have a memory
  Eigen::Index most_remembered = 4'000'000;       // numbers of all memories: 17 MB of a file
};

struct PathFrame {
  double time = 0;         // s, under the drag
  double energy = 0;       // stored, N mm
  double friction = 0;     // what friction has taken so far, N mm
  double hands = 0;        // what hands have put in so far, N mm
  double stretch = 0;      // mean_stretch
  double moved = 0;        // how far tiles have moved so far, in the mean, mm
  Poses poses;             // of all bodies of the world
  Eigen::VectorXd memory;  // where the path stood (path_memory.hpp), as far as there is room
};

// Makes frames of a path that goes on from `last` count on from there.
void count_on(std::vector<PathFrame>& frames, const PathFrame& last);

struct ActuationPath {
  std::vector<PathFrame> frames;
  bool at_rest = false;  // all forces balance
  bool stopped = false;  // by whoever watches: the path so far
  // N mm: by which stored energy less the work of hands rose in a step, at most, and stored energy
  // between steps where contact points were found anew, in all.
  double largest_rise = 0, found_anew = 0;
  double deepest = 0;  // mm: of points in faces at the end of steps, at most
  int steps = 0, iterations = 0, factorizations = 0;
};

// A path step by step, from where the world's bodies are.
class PathFollower {
 public:
  // All outlive it. hands: of the world's energies, what is not stored but put in.
  PathFollower(const TileBodies& bodies, TileWorld& world, const PathOptions& options,
               const PointLoads* hands = nullptr);
  // The world's next step, and a frame of it. At rest nothing moves. Throws Cancelled.
  StepReport step();
  // What there is of the path so far, with some most_frames frames.
  ActuationPath take();
  const ActuationPath& path() const { return path_; }
  double energy() const { return now_.energy; }  // stored, N mm

 private:
  void keep();
  double pushing() const { return hands_ ? hands_->value(world_.world->poses()) : 0; }

  const TileBodies& bodies_;
  TileWorld& world_;
  PathOptions options_;
  const PointLoads* hands_;
  ActuationPath path_;
  PathFrame now_;
};

// Moves the world's bodies, from where they are, until they are at rest. Where it is stopped, or
// does not converge, the path ends there.
ActuationPath follow_path(const TileBodies& bodies, TileWorld& world, const PathOptions& options);

}  // namespace curveups
