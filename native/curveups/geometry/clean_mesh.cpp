// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/clean_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

constexpr double merge_share = 1e-7;
using Face = std::array<int, 3>;

// Longest edge of a face: its number.
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
  return (b - a).cross(c - a).norm() <= 1e-10 * longest;  // nan: not flat, reported elsewhere
}

// For each vertex the lowest one within the tolerance.
std::vector<int> merged_vertices(const Points3& V, double tolerance) {
  std::map<std::array<long long, 3>, std::vector<int>> cells;
  std::vector<int> target(V.rows());
  for (int v = 0; v < V.rows(); ++v) {
    target[v] = v;
    if (!V.row(v).allFinite()) continue;
    std::array<long long, 3> cell;
    for (int k = 0; k < 3; ++k) {
      cell[k] = std::llround(std::clamp(V(v, k) / (2 * tolerance), -4e18, 4e18));
    }
    for (int n = 0; n < 27; ++n) {
      const auto it =
          cells.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (it == cells.end()) continue;
      for (int w : it->second) {
        if ((V.row(w) - V.row(v)).norm() <= tolerance) target[v] = std::min(target[v], w);
      }
    }
    if (target[v] == v) cells[cell].push_back(v);
  }
  return target;
}

// Removes one after the other the faces whose corners lie on a line. Returns how many.
int remove_slivers(const Points3& V, std::vector<Face>& faces) {
  std::map<std::pair<int, int>, std::vector<int>> at;  // edge -> faces
  const auto link = [&](int f) {
    for (int t = 0; t < 3; ++t) at[std::minmax(faces[f][t], faces[f][next3(t)])].push_back(f);
  };
  const auto unlink = [&](int f) {
    for (int t = 0; t < 3; ++t) {
      auto& list = at[std::minmax(faces[f][t], faces[f][next3(t)])];
      list.erase(std::remove(list.begin(), list.end(), f), list.end());
    }
  };
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) link(f);
  std::vector<char> dead(faces.size(), 0);
  int removed = 0;
  // Splitting may make new slivers along a row of points on a line: they come later in the list.
  // Each step takes one face away and may add one, so a bound keeps hostile input from going on.
  const std::size_t bound = 4 * faces.size() + 16;
  for (std::size_t f = 0; f < faces.size() && f < bound; ++f) {
    if (!flat(V, faces[f])) continue;
    const int t = longest_side(V, faces[f]);
    const int a = faces[f][t], b = faces[f][next3(t)], c = faces[f][prev3(t)];
    unlink(static_cast<int>(f));
    dead[f] = 1;
    ++removed;
    const std::vector<int> others = at[std::minmax(a, b)];
    for (int g : others) {
      int s = 0;
      while (!(faces[g][s] != a && faces[g][s] != b)) ++s;  // the corner opposite to the edge
      const int d = faces[g][s], p = faces[g][next3(s)], q = faces[g][prev3(s)];
      if (d == c) continue;
      unlink(g);
      dead[g] = 1;
      faces.push_back({d, p, c});
      faces.push_back({d, c, q});
      dead.resize(faces.size(), 0);
      link(static_cast<int>(faces.size()) - 2);
      link(static_cast<int>(faces.size()) - 1);
    }
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!dead[f]) faces[kept++] = faces[f];
  }
  faces.resize(kept);
  return removed;
}

struct Orientation {
  std::vector<char> turn;  // per face
  bool consistent = true;
};

// Walks over edges of two faces; each component keeps the orientation of its larger area.
Orientation orient(const Points3& V, const std::vector<Face>& faces) {
  std::map<std::pair<int, int>, std::vector<int>> at;
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    for (int t = 0; t < 3; ++t) at[std::minmax(faces[f][t], faces[f][next3(t)])].push_back(f);
  }
  const auto runs = [&](int f, int a, int b) {  // along a -> b
    for (int t = 0; t < 3; ++t) {
      if (faces[f][t] == a && faces[f][next3(t)] == b) return true;
    }
    return false;
  };
  Orientation out;
  out.turn.assign(faces.size(), 0);
  std::vector<char> seen(faces.size(), 0);
  for (std::size_t seed = 0; seed < faces.size(); ++seed) {
    if (seen[seed]) continue;
    std::vector<int> part(1, static_cast<int>(seed));
    seen[seed] = 1;
    double area[2] = {0, 0};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const int f = part[i];
      const Vec3 a = V.row(faces[f][0]), b = V.row(faces[f][1]), c = V.row(faces[f][2]);
      area[out.turn[f] ? 1 : 0] += (b - a).cross(c - a).norm();
      for (int t = 0; t < 3; ++t) {
        const int p = faces[f][t], q = faces[f][next3(t)];
        const std::vector<int>& two = at[std::minmax(p, q)];
        if (two.size() != 2) continue;
        const int g = two[0] == f ? two[1] : two[0];
        const char turn = static_cast<char>(runs(g, p, q) ? !out.turn[f] : out.turn[f]);
        if (!seen[g]) {
          seen[g] = 1;
          out.turn[g] = turn;
          part.push_back(g);
        } else if (out.turn[g] != turn) {
          out.consistent = false;
        }
      }
    }
    if (area[1] > area[0]) {
      for (int f : part) out.turn[f] = !out.turn[f];
    }
  }
  return out;
}

std::vector<Face> face_list(const TriangleMesh& mesh) {
  std::vector<Face> faces(mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) faces[f] = {mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)};
  return faces;
}

}  // namespace

bool has_no_area(const TriangleMesh& mesh, int face) {
  return flat(mesh.V, {mesh.F(face, 0), mesh.F(face, 1), mesh.F(face, 2)});
}

bool is_orientable(const TriangleMesh& mesh) { return orient(mesh.V, face_list(mesh)).consistent; }

CleanMesh clean_mesh(const TriangleMesh& soup) {
  for (int f = 0; f < soup.F.rows(); ++f) {
    if (soup.F.row(f).minCoeff() < 0 || soup.F.row(f).maxCoeff() >= soup.V.rows()) {
      throw InvalidInput("face " + std::to_string(f + 1) + " names a vertex that does not exist",
                         "repair the file", {f});
    }
  }
  CleanMesh out;
  const auto note = [&](std::size_t count, const char* what) {
    if (count > 0) out.notes.push_back(std::to_string(count) + what);
  };
  double size = 0;  // of the finite vertices' bounding box
  for (int k = 0; k < 3; ++k) {
    double low = 1e300, high = -1e300;
    for (int v = 0; v < soup.V.rows(); ++v) {
      if (!soup.V.row(v).allFinite()) continue;
      low = std::min(low, soup.V(v, k));
      high = std::max(high, soup.V(v, k));
    }
    size = std::max(size, high - low);
  }
  std::vector<Face> faces = face_list(soup);
  if (size > 0 && std::isfinite(size)) {
    const std::vector<int> target = merged_vertices(soup.V, merge_share * size);
    std::size_t merged = 0;
    for (int v = 0; v < soup.V.rows(); ++v) merged += target[v] != v;
    for (Face& face : faces) {
      for (int& v : face) v = target[v];
    }
    note(merged, " coincident vertices merged");
  }
  const auto collapsed = std::remove_if(faces.begin(), faces.end(), [](const Face& f) {
    return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
  });
  const std::size_t lost = faces.end() - collapsed;
  faces.erase(collapsed, faces.end());
  note(lost + remove_slivers(soup.V, faces), " faces without area removed");
  std::set<Face> known;
  const auto doubled = std::remove_if(faces.begin(), faces.end(), [&](Face face) {
    std::sort(face.begin(), face.end());
    return !known.insert(face).second;
  });
  note(faces.end() - doubled, " doubled faces removed");
  faces.erase(doubled, faces.end());
  const Orientation orientation = orient(soup.V, faces);
  if (orientation.consistent) {
    std::size_t turned = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!orientation.turn[f]) continue;
      std::swap(faces[f][1], faces[f][2]);
      ++turned;
    }
    note(turned, " faces turned over to agree with their neighbours");
  }
  std::vector<int> number(soup.V.rows(), -1);
  for (const Face& face : faces) {
    for (int v : face) number[v] = 0;
  }
  int used = 0;
  for (int& n : number) n = n < 0 ? -1 : used++;
  out.mesh.V.resize(used, 3);
  for (int v = 0; v < soup.V.rows(); ++v) {
    if (number[v] >= 0) out.mesh.V.row(number[v]) = soup.V.row(v);
  }
  out.mesh.F.resize(faces.size(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int t = 0; t < 3; ++t) out.mesh.F(f, t) = number[faces[f][t]];
  }
  return out;
}

}  // namespace curveups
