// SPDX-License-Identifier: LGPL-2.1-or-later
// Tiles as frustums in the actuated configuration: one per triangle of the mesh, its side walls in
// the bisector planes of neighbouring faces (paper, section 4; method: "Objects").
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/core/rigid_motion.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

enum class Side { front = 0, back = 1 };

// "front" or "back".
inline const char* side_name(Side side) { return side == Side::front ? "front" : "back"; }

// M x 2, a value for each side of each tile: front, back.
using PerSide = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

// Two tiles that touch when actuated: an interior, uncut edge.
struct Contact {
  int edge;                 // in topology.edges
  std::array<int, 2> tile;  // tile[0] < tile[1]
  std::array<int, 2> side;  // which edge (0 to 2) of each tile
};

struct TileMesh {
  TriangleMesh mesh;
  MeshTopology topology;
  std::vector<char> cut;  // per edge: 1 where a cut disconnects its tiles
  std::vector<Contact> contacts;
  double H_body = 0;

  // Per tile. All but `frame` in the tile's own coordinates: the origin is its front corner 0, x
  // runs along its edge 0, z along the outward (front) normal. Its body fills -H_body <= z <= 0.
  std::vector<RigidMotion> frame;          // from the tile's coordinates to the world
  std::vector<std::array<Vec2, 3>> front;  // front corners, counter-clockwise
  std::vector<std::array<Vec2, 3>> back;   // back corners before truncation
  Array3 length;                           // of front edges, mm
  Array3 dihedral;    // signed dihedral deviation at each edge, rad: convex (ridge) positive, 0 at
                      // the boundary; kept across cuts, whose lips stand side by side when actuated
  Array3 back_shift;  // inset of each back edge from the front one, mm: H_body tan(dihedral / 2)
  Eigen::VectorXd area;  // of front triangles, mm2

  Vec3 normal(int tile) const { return frame[tile].R.col(2); }
  int tile_count() const { return static_cast<int>(mesh.F.rows()); }
  const std::array<Vec2, 3>& corners(int tile, Side side) const {
    return side == Side::front ? front[tile] : back[tile];
  }
  // Outward unit normal of wall t in the tile's frame (its plane passes through front edge t).
  Vec3 wall_normal(int tile, int t) const;
  // Unit vector in the plane, from front edge t into the tile.
  Vec2 inward(int tile, int t) const;
};

// The triangle whose edges lie distance[t] inside the edges of `triangle` (negative: outside).
std::array<Vec2, 3> inset_triangle(const std::array<Vec2, 3>& triangle,
                                   const std::array<double, 3>& distance);

// cuts: C x 2 vertex pairs. Throws TopologyError (see build_topology), InvalidInput (a cut that is
// no interior edge, a face without area). A fold so sharp that a back
// face vanishes or turns over is left to tiles_without_back.
TileMesh make_tile_mesh(const TriangleMesh& mesh, const Edges& cuts, double H_body);

// Lengths of a tile's back triangle over those of its front triangle, which is similar; negative
// where folds turn it over.
double back_scale(const TileMesh& tiles, int tile);

// Tiles with a back_scale below 1e-3: their folds are too sharp for this thickness.
std::vector<int> tiles_without_back(const TileMesh& tiles);

// Throws InfeasibleDesign with tiles_without_back where there are any.
void require_back_faces(const TileMesh& tiles);

// N x 2, the tiles of each contact.
Edges contact_tiles(const TileMesh& tiles);

// Tiles of each vertex, ascending.
std::vector<std::vector<int>> tiles_at_vertices(const TileMesh& tiles);

// Tiles of each piece (component joined by uncut edges), ascending, in the order of their first.
std::vector<std::vector<int>> pieces_of(const TileMesh& tiles);

// Name of a tile in files and messages: "T00001" for tile 0.
std::string tile_name(int tile);
// Names of the first six, separated by commas, and the number of the others.
std::string tile_names(const std::vector<int>& tiles);

}  // namespace curveups
