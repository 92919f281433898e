// SPDX-License-Identifier: LGPL-2.1-or-later
// States in which a piece comes to rest: relaxed from its target without friction; and on the path
// from flat, released, then shaken, then pressed over its former and let go.
//
// One integrator (contact/contact_world) moves the tiles under all loads. To relax, each step is
// solved to its end: only the minimum of energy counts. On the path the motion is overdamped, as
// membranes are slow and tiles light: neighbours resist one another with a drag of 1 N s / mm
// (contact/drag), and friction follows Coulomb's law. Drag and friction take stored energy. All
// touching walls are equally stiff on the path, so that corners do not sink into one another.
#pragma once

#include "curveups/actuation/flat_piece.hpp"
#include "curveups/contact/virtual_scan.hpp"

namespace curveups {

enum class LoadCase { relaxed, released, shaken, pressed };

struct PathOptions {
  int max_steps = 1000;  // per load case, once nothing but friction and membranes act
  int most_frames = 60;  // about, for the release, evenly by the motion of tiles, with both ends
};

// Frame of the path.
struct PathFrame {
  LoadCase load = LoadCase::released;
  double time = 0;      // s, under the drag
  double energy = 0;    // stored, N mm
  double friction = 0;  // work done against friction so far, N mm
  double stretch = 0;   // mean_stretch
  double moved = 0;     // mean distance that tiles have covered so far, mm
  FrameRows tiles;
};

// End of a load case.
struct RestState {
  bool at_rest = false;       // all forces balance
  double energy = 0;          // N mm
  VirtualScan scan;           // of the front surface, beside the target
  Eigen::VectorXd deviation;  // per tile, mean of its samples, mm
  FrameRows tiles;
  std::vector<std::array<int, 2>> open_contacts;  // pairs of tiles whose contact carries nothing
  double push = 0;                                // mean normal force of the contacts, N
  int last_frame = 0;                             // number in the path
  int steps = 0;
  int taps = 0;               // shaken
  double force = 0;           // pressed: N on a tile
  double element_change = 0;  // relaxed: as TileWorld::solve_elements has it
};

class Path {
 public:
  // world: without weight or ground, in the actuated configuration, which is the shape of the
  // former. target: reference of scans. All outlive the path.
  Path(const TileBodies& bodies, TileWorld& world, const TriangleMesh& target, double friction,
       const PathOptions& options);

  // Goes to the minimum of energy without friction, from the actuated configuration; first of all.
  // With `solved`, its membranes' finite elements are solved where the tiles rest, and these relax
  // on under their forces. Throws Cancelled.
  RestState relax(SolvedDesign* solved);
  // Starts from the layout, under reduced membranes alone: at the ends of the path, forces of
  // finite elements move the mean distance by a hundredth. This and the following load cases end
  // where the piece comes to rest, goes round in circles or has taken max_steps. They throw
  // Cancelled; the frames so far stay.
  RestState release();
  // Goes on with taps, each of which lets go of friction for six steps, until two in a row lower
  // the energy by less than a ten-thousandth.
  RestState shake();
  // Goes on with a force on each tile towards its place on the former, which is fitted to its
  // piece: without friction, as if it were shaken, then with friction. Then lets the piece go.
  RestState press();

  const std::vector<PathFrame>& frames() const { return frames_; }

 private:
  class Former;

  void begin(LoadCase load);
  bool step();
  void run(int most_steps);
  void fit_former();
  RestState finish(int most_frames);
  void describe();
  Poses tile_poses() const;

  const TileBodies& bodies_;
  const TileMesh& tiles_;
  TileWorld& piece_;
  ContactWorld& world_;
  const TriangleMesh& target_;
  Former* former_;  // energy in the world
  PathOptions options_;
  double friction_;
  Points3 centres_;
  Poses actuated_;  // tiles
  std::vector<std::vector<int>> pieces_;

  std::vector<PathFrame> frames_;
  PathFrame now_;
  RestState state_;
  std::size_t first_frame_ = 0;  // in the load case
};

}  // namespace curveups
