// SPDX-License-Identifier: LGPL-2.1-or-later
// From flat to shape: whether a piece gets there by itself, at which friction it still does,
// whether it could come to rest elsewhere (a trap), and what hands can do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curveups/actuation/flat_piece.hpp"
#include "curveups/actuation/hands.hpp"
#include "curveups/actuation/release.hpp"

namespace curveups {

struct ActuationOptions {
  std::optional<FrameRows> start;  // where tiles begin; none: flat
  // Of a path of the same design that came by `start` (PathFrame::memory), at any friction: it goes
  // on from there. None: contacts remember nothing, and nodes are amid their pins.
  std::optional<Eigen::VectorXd> memory;
  bool answers = true;  // else the path alone
  bool hands = true;    // with the answers: what brings it home where it does not arrive
  ChosenTouch touch;    // with hands, from flat: what they press
  // How paths from flat begin (release_phases). All but "cut" need `start` to be none and gravity
  // to be off.
  std::string release = "cut";
  PathOptions path;
};

// A part of a path, up to where the piece comes to rest with what hands have left on it.
struct PathPhase {
  std::string name;     // release_phases
  int first_frame = 0;  // of the path's
  PathEnd end;          // with its own steps
  double removed = 0;   // N mm of stored energy that went with what hands cut off when it began
};

// What is around the piece until it is cut out.
struct SurplusFigures {
  int anchors = 0;
  Vec2 box, window;  // as Surplus has them
};

struct ActuatedDesign {
  ActuationPath path;                     // at the design's own friction
  PathEnd end;                            // of it
  std::string release;                    // of paths from flat
  std::vector<PathPhase> phases;          // of the path; one where the piece is cut out at once
  std::optional<SurplusFigures> surplus;  // where it is part of the path
  PathEnd from_target;   // where the actuated piece comes to rest at the same friction
  double tolerance = 0;  // mm, hold_tolerance
  int contacts = 0;      // of the design
  // Whether it comes to rest within the tolerance of from_target, all contacts closed. None without
  // an answer: a path that is needed for it did not come to rest.
  std::optional<bool> arrives;
  // From flat at other frictions, ascending, and at the design's own: none first; quarters of its
  // own where it does not arrive with that, unless contacts stay open without friction.
  std::vector<PathEnd> sampled;
  std::optional<double> reach_friction;  // the largest of those at which it arrives
  // Without friction, flat and actuated pieces end differently.
  std::optional<bool> trap;
  PathEnd frictionless_from_target;
  double trap_distance = 0;    // mm, mean, between the two ends
  std::optional<Hands> hands;  // where it does not arrive; none where that was stopped
  // Of the last frame: 3 M x 3 front corners, fitted to the design, and per tile the mean distance.
  Points3 corners;
  Eigen::VectorXd deviation;
  std::vector<FrameRows> frames, hand_frames;  // of path and hands, as files have them

  bool has_arrived(const PathEnd& one) const {
    return one.open_contacts.empty() && one.shortfall <= tolerance;
  }
};

// Stopped while tiles move, it returns the path so far, without
// answers; before that it throws Cancelled. Throws InvalidInput for gravity=held (a piece that
// rises is held nowhere), for a memory that is not of `start`, for a release that can't be and for
// a touch without hands or not from flat, and what check_touch, frame_poses, unpacked,
// make_tile_bodies, solve_design, make_tile_world and Surplus throw.
ActuatedDesign actuate_design(const Design& design, const ActuationOptions& options,
                              const Progress& progress);

}  // namespace curveups
