// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/clean_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/disjoint_sets.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/face_soup.hpp"

namespace curveups {
namespace {

constexpr double merge_share = 1e-7;
using Face = std::array<int, 3>;

// Number (0 to 2) of the longest edge.
int longest_side(const Points3& V, const Face& face) {
  int best = 0;
  double longest = -1;
  for (int t = 0; t < 3; ++t) {
    const double length = (V.row(face[next3(t)]) - V.row(face[t])).squaredNorm();
    if (length > longest) {
      longest = length;
      best = t;
    }
  }
  return best;
}

bool flat(const Points3& V, const Face& face) {
  if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) return true;
  const Vec3 a = V.row(face[0]), b = V.row(face[1]), c = V.row(face[2]);
  const int t = longest_side(V, face);
  const double longest = (V.row(face[next3(t)]) - V.row(face[t])).squaredNorm();
  return (b - a).cross(c - a).norm() <= 1e-10 * longest;  // false for NaN, which check_mesh reports
}

Eigen::AlignedBox3d box_of(const Points3& V) {  // box around the finite vertices
  Eigen::AlignedBox3d box;
  for (int v = 0; v < V.rows(); ++v) {
    if (V.row(v).allFinite()) box.extend(Vec3(V.row(v)));
  }
  return box;
}

// Sets of vertices that chains of distances within the tolerance join. A sweep along a direction in
// which few surfaces have many vertices finds them.
DisjointSets merged_vertices(const Points3& V, double tolerance) {
  const Eigen::VectorXd place = V * Vec3(0.6015, 0.5347, 0.5934);  // a unit vector
  std::vector<int> order;
  for (int v = 0; v < V.rows(); ++v) {
    if (V.row(v).allFinite()) order.push_back(v);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) { return place[a] < place[b]; });
  DisjointSets sets(V.rows());
  for (std::size_t k = 0; k < order.size(); ++k) {
    checkpoint_now_and_then(k);
    for (std::size_t l = k; l-- > 0 && place[order[k]] - place[order[l]] <= tolerance;) {
      if ((V.row(order[k]) - V.row(order[l])).norm() <= tolerance) sets.unite(order[k], order[l]);
    }
  }
  return sets;
}

int flat_count(const Points3& V, const std::vector<Face>& faces) {
  return static_cast<int>(
      std::count_if(faces.begin(), faces.end(), [&](const Face& f) { return flat(V, f); }));
}

void remove_marked(std::vector<Face>& faces, const std::vector<char>& marked) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!marked[f]) faces[kept++] = faces[f];
  }
  faces.resize(kept);
}

// Removes the faces whose corners lie on a line and splits the faces beyond their longest edges at
// the corner that lies there. Returns how many are gone.
int remove_slivers(const Points3& V, std::vector<Face>& faces) {
  const int before = flat_count(V, faces);
  if (before == 0) return 0;
  std::unordered_map<std::uint64_t, std::vector<int>> at;  // edge -> faces
  at.reserve(2 * faces.size());
  // The sliver with the longest edge goes first: it splits faces with area, or slivers over the
  // same edge, and no removed edge returns.
  std::priority_queue<std::pair<double, int>> slivers;
  std::vector<char> dead;
  const auto list_at = [&](int a, int b) -> std::vector<int>& { return at[edge_key(a, b)]; };
  const auto link = [&](int f) {
    const Face& face = faces[f];
    dead.push_back(0);
    for (int t = 0; t < 3; ++t) list_at(face[t], face[next3(t)]).push_back(f);
    if (!flat(V, face)) return;
    const int t = longest_side(V, face);
    slivers.emplace((V.row(face[next3(t)]) - V.row(face[t])).squaredNorm(), f);
  };
  const auto unlink = [&](int f) {
    dead[f] = 1;
    for (int t = 0; t < 3; ++t) {
      auto& list = list_at(faces[f][t], faces[f][next3(t)]);
      list.erase(std::remove(list.begin(), list.end(), f), list.end());
    }
  };
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    checkpoint_now_and_then(f);
    link(f);
  }
  // Edges of more than two faces multiply the splits; the bound ends that.
  const std::size_t bound = 16 * faces.size() + 64;
  for (std::size_t step = 0; !slivers.empty() && faces.size() < bound; ++step) {
    checkpoint_now_and_then(step);
    const int f = slivers.top().second;
    slivers.pop();
    if (dead[f]) continue;
    const int t = longest_side(V, faces[f]);
    const int a = faces[f][t], b = faces[f][next3(t)], c = faces[f][prev3(t)];
    unlink(f);
    for (int g : std::exchange(list_at(a, b), {})) {
      checkpoint();
      int s = 0;
      while (!(faces[g][s] != a && faces[g][s] != b)) ++s;  // the corner opposite to the edge
      const int d = faces[g][s], p = faces[g][next3(s)], q = faces[g][prev3(s)];
      if (d == c) {  // the same three corners
        list_at(a, b).push_back(g);
        continue;
      }
      unlink(g);
      for (const Face& part : {Face{d, p, c}, Face{d, c, q}}) {
        faces.push_back(part);
        link(static_cast<int>(faces.size()) - 1);
      }
    }
  }
  remove_marked(faces, dead);
  return before - flat_count(V, faces);
}

// Duplicates vertices until all faces of each are neighbours of one another. Returns how many there
// are; none where more than two faces meet in an edge.
int part_vertices(TriangleMesh& mesh) {
  DisjointSets corners(3 * mesh.F.rows());  // corners of faces, joined around vertices
  bool manifold = true;
  const auto corner_at = [&](const EdgeSide& side, int vertex) {
    return 3 * side.face + (mesh.F(side.face, side.side) == vertex ? side.side : next3(side.side));
  };
  visit_edges(mesh.F, [&](const EdgeSide* begin, const EdgeSide* end) {
    manifold = manifold && end - begin <= 2;
    if (end - begin != 2) return;
    for (const int v : {begin->low, begin->high}) {
      corners.unite(corner_at(begin[0], v), corner_at(begin[1], v));
    }
  });
  if (!manifold) return 0;
  const int before = static_cast<int>(mesh.V.rows());
  std::vector<int> first(before, -1);  // set of corners that keeps the vertex
  std::unordered_map<int, int> copies;
  std::vector<int> original;
  for (int c = 0; c < 3 * mesh.F.rows(); ++c) {
    const int v = mesh.F(c / 3, c % 3), set = static_cast<int>(corners.find(c));
    if (first[v] < 0) first[v] = set;
    if (first[v] == set) continue;
    const auto [at, added] = copies.emplace(set, before + static_cast<int>(original.size()));
    if (added) original.push_back(v);
    mesh.F(c / 3, c % 3) = at->second;
  }
  const int count = static_cast<int>(original.size());
  mesh.V.conservativeResize(before + count, 3);
  for (int k = 0; k < count; ++k) mesh.V.row(before + k) = mesh.V.row(original[k]);
  draw_apart(mesh, before);
  return count;
}

}  // namespace

void draw_apart(TriangleMesh& mesh, int first) {
  const Eigen::Index count = mesh.V.rows();
  Eigen::VectorXd shortest =
      Eigen::VectorXd::Constant(count, std::numeric_limits<double>::infinity());
  Points3 inwards = Points3::Zero(count, 3);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) {
      const int a = mesh.F(f, t);
      for (int b : {mesh.F(f, next3(t)), mesh.F(f, prev3(t))}) {
        const Vec3 d = mesh.V.row(b) - mesh.V.row(a);
        shortest[a] = std::min(shortest[a], d.norm());
        inwards.row(a) += d;
      }
    }
  }
  for (Eigen::Index v = first; v < count; ++v) {
    const double size = inwards.row(v).norm();
    if (size > 0) mesh.V.row(v) += 1e-3 * shortest[v] / size * inwards.row(v);
  }
}

bool has_no_area(const TriangleMesh& mesh, int face) {
  return flat(mesh.V, {mesh.F(face, 0), mesh.F(face, 1), mesh.F(face, 2)});
}

CleanMesh clean_mesh(const TriangleMesh& soup) {
  std::vector<Face> faces(soup.F.rows());
  for (int f = 0; f < soup.F.rows(); ++f) {
    faces[f] = {soup.F(f, 0), soup.F(f, 1), soup.F(f, 2)};
    if (soup.F.row(f).minCoeff() < 0 || soup.F.row(f).maxCoeff() >= soup.V.rows()) {
      throw InvalidInput("face " + std::to_string(f + 1) + " names a vertex that does not exist",
                         "repair the file", {f});
    }
  }
  CleanMesh out;
  const auto note = [&](std::size_t count, const char* what) {
    if (count > 0) out.notes.push_back(std::to_string(count) + what);
  };
  const Eigen::AlignedBox3d box = box_of(soup.V);
  if (!box.isEmpty()) {
    const double size = box.sizes().maxCoeff();
    if (box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() >
        tolerance::largest_coordinate) {
      throw InvalidInput("coordinates are beyond 1e8 mm, where files lose all digits",
                         "move the surface to the origin, or check its unit (scale)");
    }
    if (size == 0) {
      throw InvalidInput("all corners of the surface lie in one point",
                         "check the file, and the transformations in it");
    }
    DisjointSets sets = merged_vertices(soup.V, merge_share * size);
    std::size_t merged = 0;
    for (int v = 0; v < soup.V.rows(); ++v) merged += sets.find(v) != v;
    for (Face& face : faces) {
      for (int& v : face) v = sets.find(v);
    }
    note(merged, " coincident vertices merged");
  }
  std::vector<char> collapsed;
  for (const Face& f : faces) {
    collapsed.push_back(f[0] == f[1] || f[1] == f[2] || f[2] == f[0]);
  }
  remove_marked(faces, collapsed);
  note(std::count(collapsed.begin(), collapsed.end(), 1) + remove_slivers(soup.V, faces),
       " faces without area removed");
  const auto rows = [&] {
    Triangles F(faces.size(), 3);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      F.row(f) << faces[f][0], faces[f][1], faces[f][2];
    }
    return F;
  };
  std::vector<char> repeated(faces.size(), 0);
  for (int f : repeated_faces(rows())) repeated[f] = 1;
  remove_marked(faces, repeated);
  note(std::count(repeated.begin(), repeated.end(), 1), " doubled faces removed");
  out.mesh = used_part(soup.V, rows()).mesh;
  const Orientation orientation = orientation_of(out.mesh.V, out.mesh.F);
  if (orientation.consistent) {
    std::size_t turned = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!orientation.turn[f]) continue;
      std::swap(out.mesh.F(f, 1), out.mesh.F(f, 2));
      ++turned;
    }
    note(turned, " faces turned over to agree with their neighbours");
    note(part_vertices(out.mesh), " corners taken apart where parts touched");
  }
  return out;
}

}  // namespace curveups
