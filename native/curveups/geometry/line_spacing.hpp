// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines of a surface that stay edges of its tiling (creases, given features, the boundary), and
// evenly spaced vertices on them.
#pragma once

#include <vector>

#include "curveups/geometry/isotropic_mesh.hpp"

namespace curveups {

// Polyline by arc length. arc: lengths up to its points, and the whole length of a closed one.
struct Course {
  std::vector<Vec3> points;
  bool closed;
  std::vector<double> arc;

  Course(std::vector<Vec3> line, bool is_closed);
  double length() const { return arc.back(); }
  Vec3 at(double s) const;  // a closed line goes on beyond its ends
  Vec3 closest(const Vec3& p) const;
};

// Angle between the directions of two edges, rad.
double turn(const Vec3& in, const Vec3& out);

// Interior edges (vertex pairs, lower vertex first, ascending) where the normals of the two faces
// differ by more than `angle` (rad). Connected sets of edges shorter than `least` (mm) altogether
// are noise and left out. Faces without area have no creases.
Edges crease_edges(const TriangleMesh& mesh, const MeshTopology& topology, double angle,
                   double least);

struct FeatureLine {
  std::vector<int> vertices;  // along the line; of a closed line each once
  bool closed;
};

// Joins edges (vertex pairs) to lines, which end where other than two edges meet and in vertices
// with `is_end`. In the order of the lowest vertices.
std::vector<FeatureLine> feature_lines(const Edges& edges, const std::vector<char>& is_end);

// Inserts vertices into boundary edges and `features` (vertex pairs; their faces are split into
// fans), so that each stretch between two corners (turns above `corner_angle`, rad, and ends of
// features), or each whole loop, is divided into equal arcs of about `length`, a loop into three at
// least. These vertices and the corners are fixed, all others free. Pairs that are no edge are left
// out. Ragged lines: with `reach` (mm) above 0 a corner also turns by that much between points this
// far on either side, and only the sharpest of corners within the reach counts.
IsotropicMesh space_lines(const TriangleMesh& mesh, const Edges& features, double length,
                          double corner_angle, double reach = 0);

}  // namespace curveups
