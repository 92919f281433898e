// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/tile_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {
namespace {

RigidMotion make_frame(const TriangleMesh& mesh, int tile) {
  const Vec3 a = mesh.V.row(mesh.F(tile, 0)), b = mesh.V.row(mesh.F(tile, 1)),
             c = mesh.V.row(mesh.F(tile, 2));
  const Vec3 x = (b - a).normalized(), z = (b - a).cross(c - a).normalized();
  RigidMotion frame;
  frame.R << x, z.cross(x), z;
  frame.t = a;
  return frame;
}

}  // namespace

std::array<Vec2, 3> inset_triangle(const std::array<Vec2, 3>& triangle,
                                   const std::array<double, 3>& distance) {
  std::array<Vec2, 3> direction, out;
  for (int t = 0; t < 3; ++t) direction[t] = (triangle[next3(t)] - triangle[t]).normalized();
  for (int t = 0; t < 3; ++t) {
    const Vec2 along = direction[t], back = -direction[prev3(t)];
    out[t] = triangle[t] + (distance[prev3(t)] * along + distance[t] * back) / wedge(along, back);
  }
  return out;
}

Vec3 TileMesh::wall_normal(int tile, int t) const {
  const Vec2 out = -inward(tile, t);
  const double half = 0.5 * dihedral(tile, t);
  // The wall leans inwards by half the fold on a ridge: its back edge lies H tan(half) inside.
  return Vec3(out.x() * std::cos(half), out.y() * std::cos(half), -std::sin(half));
}

Vec2 TileMesh::inward(int tile, int t) const {
  return left_of((front[tile][next3(t)] - front[tile][t]) / length(tile, t));
}

TileMesh make_tile_mesh(const TriangleMesh& mesh, const Edges& cuts, double H_body) {
  TileMesh tiles;
  tiles.mesh = mesh;
  tiles.topology = build_topology(mesh.F);
  tiles.cut = mark_cuts(tiles.topology, cuts);
  tiles.H_body = H_body;
  const int count = tiles.tile_count();
  tiles.frame.resize(count);
  tiles.front.resize(count);
  tiles.back.resize(count);
  tiles.length.resize(count, 3);
  tiles.dihedral.setZero(count, 3);
  tiles.back_shift.setZero(count, 3);
  tiles.area.resize(count);
  std::vector<int> flat;
  for (int i = 0; i < count; ++i) {
    tiles.area(i) = face_area_vector(mesh, i).norm();
    for (int t = 0; t < 3; ++t) {
      tiles.length(i, t) = (mesh.V.row(mesh.F(i, next3(t))) - mesh.V.row(mesh.F(i, t))).norm();
    }
    const double longest = tiles.length.row(i).maxCoeff();
    if (!(tiles.area(i) > 1e-9 * longest * longest)) flat.push_back(i);
  }
  if (!flat.empty()) {
    throw InvalidInput(std::to_string(flat.size()) + " faces have no area",
                       "remove degenerate faces or let the target be remeshed", flat);
  }
  for (int i = 0; i < count; ++i) {
    tiles.frame[i] = make_frame(mesh, i);
    for (int t = 0; t < 3; ++t) {
      const Vec3 p = tiles.frame[i].to_own(mesh.V.row(mesh.F(i, t)));
      tiles.front[i][t] = p.head<2>();
    }
  }
  for (std::size_t e = 0; e < tiles.topology.edges.size(); ++e) {
    const MeshEdge& edge = tiles.topology.edges[e];
    if (edge.boundary()) continue;
    const Vec3 direction = Vec3(mesh.V.row(edge.v[1]) - mesh.V.row(edge.v[0])).normalized();
    const Vec3 n0 = tiles.normal(edge.face[0]), n1 = tiles.normal(edge.face[1]);
    const double dihedral = std::atan2(n0.cross(n1).dot(direction), n0.dot(n1));
    for (int s = 0; s < 2; ++s) {
      tiles.dihedral(edge.face[s], edge.side[s]) = dihedral;
      tiles.back_shift(edge.face[s], edge.side[s]) = H_body * std::tan(0.5 * dihedral);
    }
    if (!tiles.cut[e]) {
      tiles.contacts.push_back(
          {static_cast<int>(e), {edge.face[0], edge.face[1]}, {edge.side[0], edge.side[1]}});
    }
  }
  for (int i = 0; i < count; ++i) {
    tiles.back[i] = inset_triangle(
        tiles.front[i], {tiles.back_shift(i, 0), tiles.back_shift(i, 1), tiles.back_shift(i, 2)});
  }
  return tiles;
}

// The back triangle is the front one with its edges moved in by H tan(fold / 2): similar, and
// smaller by the sum of l_t H tan(fold_t / 2) over twice the area.
double back_scale(const TileMesh& tiles, int i) {
  return 1 - tiles.back_shift.row(i).dot(tiles.length.row(i)) / (2 * tiles.area(i));
}

std::vector<int> tiles_without_back(const TileMesh& tiles) {
  std::vector<int> out;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if (!(back_scale(tiles, i) > 1e-3)) out.push_back(i);
  }
  return out;
}

void require_back_faces(const TileMesh& tiles) {
  std::vector<int> without = tiles_without_back(tiles);
  if (without.empty()) return;
  const std::string count = std::to_string(without.size());
  throw InfeasibleDesign(
      "folds are too sharp for tiles of this thickness: " + count + " back faces vanish",
      "lower H_body, raise L or smooth the target there (mend=on)", std::move(without));
}

Edges contact_tiles(const TileMesh& tiles) {
  Edges out(static_cast<Eigen::Index>(tiles.contacts.size()), 2);
  for (Eigen::Index k = 0; k < out.rows(); ++k) {
    const std::array<int, 2>& pair = tiles.contacts[static_cast<std::size_t>(k)].tile;
    out.row(k) << pair[0], pair[1];
  }
  return out;
}

std::vector<std::vector<int>> tiles_at_vertices(const TileMesh& tiles) {
  std::vector<std::vector<int>> out(tiles.mesh.V.rows());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) out[tiles.mesh.F(i, t)].push_back(i);
  }
  return out;
}

std::vector<std::vector<int>> pieces_of(const TileMesh& tiles) {
  const std::vector<int> component = pieces_of_faces(tiles.topology, tiles.cut);
  std::vector<std::vector<int>> pieces;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if (component[i] >= static_cast<int>(pieces.size())) pieces.resize(component[i] + 1);
    pieces[component[i]].push_back(i);
  }
  return pieces;
}

std::string tile_name(int tile) {
  char name[16];
  std::snprintf(name, sizeof name, "T%05d", tile + 1);
  return name;
}

std::string tile_names(const std::vector<int>& tiles) {
  constexpr std::size_t most = 6;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, tiles.size()); ++i) {
    names += (i ? ", " : "") + tile_name(tiles[i]);
  }
  if (tiles.size() > most) names += " and " + std::to_string(tiles.size() - most) + " more";
  return names;
}

}  // namespace curveups
