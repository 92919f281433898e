// SPDX-License-Identifier: LGPL-2.1-or-later
// Opens meshes along edges and takes them apart.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct CutMesh {
  TriangleMesh mesh;          // faces in the order (and with the corner order) of the input
  std::vector<int> original;  // per vertex of `mesh` the vertex of the input
};

// Turns the edges with cut[edge] != 0 into boundary: every vertex gets one copy per fan of faces
// that uncut edges join, also where the boundary touched itself; the tip of a slit stays one. The
// fan with the lowest face keeps the vertex's number, other copies follow after the input's
// vertices. cut: one entry per topology.edges, or empty for no cut; entries of boundary edges mean
// nothing.
CutMesh cut_open(const TriangleMesh& mesh, const MeshTopology& topology,
                 const std::vector<char>& cut);

// Marks `cuts` (vertex pairs, in any order) with 1 among topology.edges. Throws InvalidInput,
// naming the pair, where one is no interior edge.
std::vector<char> mark_cuts(const MeshTopology& topology, const Edges& cuts);

// Piece of each face, from 0 in the order of the lowest faces; `cut` as in cut_open.
std::vector<int> pieces_of_faces(const MeshTopology& topology, const std::vector<char>& cut);

// Part of a mesh as a mesh of its own.
struct MeshPiece {
  TriangleMesh mesh;          // only vertices that its faces use, in the order of their use
  std::vector<int> faces;     // rows of the whole mesh's F, ascending
  std::vector<int> original;  // per vertex the whole, uncut mesh's vertex
};

// part: number of each face's part, from 0.
std::vector<MeshPiece> parts_of(const TriangleMesh& mesh, const std::vector<int>& part);

// Pieces in the order of their lowest faces; `cut` as in cut_open.
std::vector<MeshPiece> cut_into_pieces(const TriangleMesh& mesh, const MeshTopology& topology,
                                       const std::vector<char>& cut);

}  // namespace curveups
