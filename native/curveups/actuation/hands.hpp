// SPDX-License-Identifier: LGPL-2.1-or-later
// What brings a piece home that has jammed on its way: shaking, then the fewest tiles that hands
// press to their places while it is shaken, and the least force of those that were tried; or how
// far shaking and pressing given tiles lead.
//
// A tap lets go of friction for one step; friction then holds as before. Hands press each of their
// tiles towards its place on the piece that is home, turned and moved to where it fits the present
// one best, with a force that fades over the last part of the way. All tiles of the piece carry
// the counterforce evenly, so that hands neither move nor turn the piece as a whole.
#pragma once

#include <optional>
#include <vector>

#include "curveups/actuation/path.hpp"
#include "curveups/actuation/path_end.hpp"

namespace curveups {

// Tiles side by side that are pressed in about the same direction.
struct HandTouch {
  std::vector<int> tiles;
  Vec3 direction;      // unit, of the first press, in the coordinates of the actuated design
  double outward = 0;  // cosine of its angle with the tiles' mean normal
  double force = 0;    // N, on each of the tiles
};

// Tiles that hands press instead of those that a search would find.
struct ChosenTouch {
  std::vector<int> tiles;       // rows of F; none: search
  std::optional<double> force;  // N a tile; none: twice the mean normal force, a round number
};

// How far a piece has come: not to its shape; within the tolerance of it; and all contacts closed.
enum class Homecoming { none, shape, home };

struct Hands {
  int taps = 0;
  PathEnd shaken;  // after shaking alone
  // Pressed all at once while the piece is shaken, then let go. Empty where shaking does it. Of a
  // search: empty where nothing that was tried brings the piece further than shaking does.
  std::vector<HandTouch> touches;
  PathEnd end;  // after all of it; without touches, where the best that was tried ends
  Homecoming reached = Homecoming::none;
  int tried = 0;                  // sets of tiles and forces
  double largest_force = 0;       // N, on a tile
  double largest_rise = 0;        // as of ActuationPath, N mm
  std::vector<PathFrame> frames;  // of shaking, and of the touches until the piece is let go
  int shaking_frames = 0;         // of them
};

struct Home {
  Poses poses;           // of the tiles of the piece that is home
  TriangleMesh shape;    // fitted_surface of it
  double tolerance = 0;  // mm
};

// The world stands where its path came to rest, with the contacts' memory; first: that path's last
// frame, from which time and what friction has taken go on. Throws Cancelled.
// hands: of its energies, without loads. chosen: as check_touch leaves it.
Hands bring_home(const TileBodies& bodies, TileWorld& world, PointLoads& hands, const Home& home,
                 double friction, const PathFrame& first, const ChosenTouch& chosen);

// Throws InvalidInput for tiles that there are not, or not once, and for a force that is none.
void check_touch(const ChosenTouch& chosen, int tile_count);

}  // namespace curveups
