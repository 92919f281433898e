// SPDX-License-Identifier: LGPL-2.1-or-later
// States in which a piece comes to rest: relaxed from its target without friction; and on the path
// from flat, released, then shaken, then pressed over its former and let go.
//
// One integrator (contact/contact_world) moves the tiles under all loads. Relaxed, each step is
// solved to its end: the minimum of energy is all that counts. On the path the motion is
// overdamped, as membranes are slow and tiles light: neighbours resist one another with a drag of
// 1 N s / mm (contact/drag), and friction follows Coulomb's law. Stored energy falls by what drag
// and friction take. All touching walls are equally stiff on the path, so that corners do not sink
// into one another.
#pragma once

#include "curveups/actuation/flat_piece.hpp"
#include "curveups/contact/virtual_scan.hpp"

namespace curveups {

enum class LoadCase { relaxed, released, shaken, pressed };

struct PathOptions {
  int max_steps = 1000;  // of a load case, once nothing but friction and membranes act
  int most_frames = 60;  // about, of the release, evenly by how far tiles move, with both ends
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
  int last_frame = 0;                             // of the path
  int steps = 0, iterations = 0, factorizations = 0;
  int taps = 0;      // of shaking
  double force = 0;  // N on a tile, of pressing
  // Relaxed: what finite elements pull there differs by this from what the tiles feel, over the
  // mean force on a tile (TileWorld::solve_elements).
  double element_change = 0;
};

class Path {
 public:
  // world: without weight or ground, its bodies where tiles are actuated, which is the shape of the
  // former. target: what scans are compared with. All outlive the path.
  Path(const TileBodies& bodies, TileWorld& world, const TriangleMesh& target, double friction,
       const PathOptions& options);

  // The minimum of energy without friction, from where the tiles are actuated; first of all. With
  // `solved`, the membranes of the actuated configuration, finite elements are solved where the
  // tiles rest, and these relax on under their forces. Throws Cancelled.
  RestState relax(SolvedDesign* solved);
  // From the layout, under reduced membranes alone: at the ends of the path, forces of finite
  // elements move the mean by a hundredth. Each load case goes on from where the piece is and ends
  // where it comes to rest, goes round in circles or has taken max_steps. Throws Cancelled; the
  // frames so far stay.
  RestState release();
  // A tap lets go of friction for six steps. Taps follow until two in a row lower the energy by
  // less than a ten-thousandth.
  RestState shake();
  // Each tile is pressed towards its place on the former, which is fitted to its piece as that
  // stands: without friction, as if it were shaken, then with friction. Then the piece is let go.
  RestState press();

  const std::vector<PathFrame>& frames() const { return frames_; }
  // N mm: largest rise of stored energy, less the work of the loads, in a step; and sum of its
  // changes between steps, where contact points are found anew.
  double largest_rise() const { return largest_rise_; }
  double found_anew() const { return found_anew_; }
  double deepest() const { return deepest_; }  // mm, of points in faces at the end of steps

 private:
  class Former;

  void begin(LoadCase load);
  bool step();
  bool run(int most_steps);
  void fit_former();
  RestState finish(int most_frames);
  void describe();
  Poses tile_poses() const;

  const TileBodies& bodies_;
  const TileMesh& tiles_;
  TileWorld& piece_;
  ContactWorld& world_;
  const TriangleMesh& target_;
  Former* former_;  // of the world's energies
  PathOptions options_;
  double friction_;
  Points3 centres_;
  Poses actuated_;  // of the tiles
  std::vector<std::vector<int>> pieces_;

  std::vector<PathFrame> frames_;
  PathFrame now_;
  RestState state_;
  std::size_t first_frame_ = 0;  // of the load case
  double largest_rise_ = 0, found_anew_ = 0, deepest_ = 0;
};

}  // namespace curveups
