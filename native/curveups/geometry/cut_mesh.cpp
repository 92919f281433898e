// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/cut_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/disjoint_sets.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {

CutMesh cut_open(const TriangleMesh& mesh, const MeshTopology& topology,
                 const std::vector<char>& cut) {
  const int face_count = static_cast<int>(mesh.F.rows());
  // Corner t of face f is number 3 f + t, and a fan is named after its lowest one.
  DisjointSets fans(3 * static_cast<std::size_t>(face_count));
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (edge.boundary() || (!cut.empty() && cut[e])) continue;
    const int f = edge.face[0], g = edge.face[1], s = edge.side[0], t = edge.side[1];
    fans.unite(3 * f + s, 3 * g + next3(t));  // the faces run along the edge in opposite directions
    fans.unite(3 * f + next3(s), 3 * g + t);
  }

  CutMesh out;
  out.mesh.F.resize(face_count, 3);
  out.original.resize(mesh.V.rows());
  std::iota(out.original.begin(), out.original.end(), 0);
  std::vector<char> taken(mesh.V.rows(), 0);
  for (int f = 0; f < face_count; ++f) {
    for (int t = 0; t < 3; ++t) {
      const int fan = fans.find(3 * f + t), v = mesh.F(f, t);
      if (fan != 3 * f + t) {
        out.mesh.F(f, t) = out.mesh.F(fan / 3, fan % 3);
      } else if (!taken[v]) {
        taken[v] = 1;
        out.mesh.F(f, t) = v;
      } else {
        out.mesh.F(f, t) = static_cast<int>(out.original.size());
        out.original.push_back(v);
      }
    }
  }
  out.mesh.V.resize(out.original.size(), 3);
  for (std::size_t v = 0; v < out.original.size(); ++v) {
    out.mesh.V.row(v) = mesh.V.row(out.original[v]);
  }
  return out;
}

std::vector<char> mark_cuts(const MeshTopology& topology, const Edges& cuts) {
  std::vector<char> cut(topology.edges.size(), 0);
  if (cuts.rows() == 0) return cut;
  std::unordered_map<std::uint64_t, int> index;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (!topology.edges[e].boundary()) {
      index[edge_key(topology.edges[e].v[0], topology.edges[e].v[1])] = static_cast<int>(e);
    }
  }
  for (int c = 0; c < cuts.rows(); ++c) {
    const auto it = index.find(edge_key(cuts(c, 0), cuts(c, 1)));
    if (it == index.end()) {
      throw InvalidInput("cut " + std::to_string(c) + " (" + std::to_string(cuts(c, 0)) + ", " +
                             std::to_string(cuts(c, 1)) + ") is no interior edge of the mesh",
                         "give pairs of neighbouring vertices of the remeshed target");
    }
    cut[it->second] = 1;
  }
  return cut;
}

std::vector<int> pieces_of_faces(const MeshTopology& topology, const std::vector<char>& cut) {
  std::vector<char> joined(topology.edges.size(), 1);
  for (std::size_t e = 0; e < cut.size(); ++e) joined[e] = !cut[e];
  return face_components(topology, joined);
}

std::vector<MeshPiece> parts_of(const TriangleMesh& mesh, const std::vector<int>& part) {
  std::vector<MeshPiece> pieces;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (part[f] >= static_cast<int>(pieces.size())) pieces.resize(part[f] + 1);
    pieces[part[f]].faces.push_back(f);
  }
  std::vector<int> index(mesh.V.rows(), -1);
  for (MeshPiece& piece : pieces) {
    checkpoint();
    piece.mesh.F = mesh.F(piece.faces, Eigen::seqN(0, 3));
    for (int& v : piece.mesh.F.reshaped<Eigen::RowMajor>()) {
      if (index[v] < 0) {
        index[v] = static_cast<int>(piece.original.size());
        piece.original.push_back(v);
      }
      v = index[v];
    }
    piece.mesh.V = mesh.V(piece.original, Eigen::seqN(0, 3));
    for (int v : piece.original) index[v] = -1;
  }
  return pieces;
}

std::vector<MeshPiece> cut_into_pieces(const TriangleMesh& mesh, const MeshTopology& topology,
                                       const std::vector<char>& cut) {
  const CutMesh open = cut_open(mesh, topology, cut);
  std::vector<MeshPiece> pieces = parts_of(open.mesh, pieces_of_faces(topology, cut));
  for (MeshPiece& piece : pieces) {
    for (int& v : piece.original) v = open.original[v];
  }
  return pieces;
}

}  // namespace curveups
