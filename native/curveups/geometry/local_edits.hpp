// SPDX-License-Identifier: LGPL-2.1-or-later
// Splits and collapses single edges of a tiling; what stays keeps its number.
#pragma once

#include <unordered_map>
#include <vector>

#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/follow_lines.hpp"
#include "curveups/geometry/follow_mesh.hpp"
#include "curveups/geometry/isotropic_mesh.hpp"

namespace curveups {

class LocalEdits {
 public:
  IsotropicMesh mesh;  // vertices keep their numbers until `finish`

  LocalEdits(TriangleMesh tiles, const LineMap& lines);

  bool on_line(int v) const { return course_[v] >= 0; }
  // Both return whether they changed anything. A vertex of a border or a crease stays on it;
  // corners stay where they are.
  bool split(const MeshEdge& edge, const ClosestPoints& surface);
  bool collapse(const MeshEdge& edge, const ClosestPoints& surface);
  // Flips edges between faces of these vertices towards regular valences.
  void flip(const std::vector<char>& near);
  // Removes what collapsed: the last rows fill gaps. before: the tiles that came in.
  void finish(const Triangles& before, FollowedMesh& out) const;
  // Takes faces that have collapsed out, after a pass of edits.
  void drop_collapsed();

 private:
  bool is_feature(const MeshEdge& edge) const;

  int borders_, before_;  // number of courses that are borders; of vertices that came in
  std::vector<Course> courses_;
  std::vector<int> course_;  // per vertex, as in LineMap
  std::vector<char> knot_, gone_;
  std::vector<int> row_;  // per face its old row, -1: new
};

}  // namespace curveups
