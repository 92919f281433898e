// SPDX-License-Identifier: LGPL-2.1-or-later
// The surplus of both membranes before it is cut off (paper, section 6.2): all of each sheet that
// is inside of its ring and not between the piece's own pins, in holes and slits too, and the
// anchors that are glued between the two. It is a mesh of triangles of the membranes' own density,
// joined to the corners of pins and to anchors, which are rigid bodies that push as tiles do.
// Nothing keeps a sheet from passing through bodies or through itself.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "curveups/contact/tile_world.hpp"

namespace curveups {

class Surplus {
 public:
  // Of a piece in the layout; `first` bodies come before those of the surplus. Throws
  // InfeasibleDesign where the layout is wider than 10 m or 1000 tiles, or folds over itself at its
  // border.
  Surplus(const TileBodies& bodies, int first);

  // Bodies and energies, before the first step of a world that has the bodies before. held: whether
  // the front and the back sheet are on their rings, else their borders there are free.
  void add_to(ContactWorld& world, std::array<bool, 2> held) const;
  // Where its bodies are while all lies flat.
  const Poses& flat() const { return poses_; }
  int anchor_count() const { return anchor_count_; }
  // x and y, mm: of all that is glued, and of the rings' windows around it.
  const Vec2& box() const { return box_; }
  const Vec2& window() const { return window_; }

 private:
  struct Sheet {
    std::vector<ReducedMembrane::SheetPoint> points;
    Points2 flat;
    std::vector<std::array<int, 3>> triangles;
    MembraneMaterial material;
    int rim = 0;  // nodes on the ring are bodies [rim, rim_end)
    int rim_end = 0;
  };
  Sheet make_sheet(const TileBodies& bodies, Side side, const std::vector<Vec2>& anchors,
                   const Vec2& middle);

  int first_, anchor_count_ = 0;
  double tau_;
  Vec2 box_, window_;
  std::vector<RigidBody> bodies_;
  Poses poses_;
  std::array<Sheet, 2> sheets_;
};

}  // namespace curveups
