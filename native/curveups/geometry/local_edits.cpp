// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/local_edits.hpp"

#include <algorithm>
#include <set>

#include "curveups/geometry/even_edges.hpp"

namespace curveups {
namespace {

constexpr int flip_rounds = 4;

// Numbers from 0 of rows by the old number of each, -1: new. Rows keep theirs; new ones take those
// that are free and then follow; where more are free, the last rows fill the gaps.
std::vector<int> numbers_of(const std::vector<int>& from, int before) {
  const int count = static_cast<int>(from.size());
  std::vector<char> used(before, 0);
  for (int old : from) {
    if (old >= 0) used[old] = 1;
  }
  std::vector<int> gaps;
  for (int number = 0; number < before; ++number) {
    if (!used[number]) gaps.push_back(number);
  }
  std::vector<int> numbers = from;
  std::size_t gap = 0;
  int next = before;
  for (int& number : numbers) {
    if (number < 0) number = gap < gaps.size() ? gaps[gap++] : next++;
  }
  for (int& number : numbers) {
    if (number >= count) number = gaps[gap++];
  }
  return numbers;
}

}  // namespace

LocalEdits::LocalEdits(TriangleMesh tiles, const LineMap& lines)
    : borders_(lines.borders),
      courses_(lines.courses),
      course_(lines.course),
      knot_(lines.knot),
      gone_(tiles.V.rows(), 0),
      row_(tiles.F.rows()) {
  for (std::size_t f = 0; f < row_.size(); ++f) row_[f] = static_cast<int>(f);
  before_ = static_cast<int>(tiles.V.rows());
  mesh.fixed.assign(tiles.V.rows(), 0);
  mesh.features = lines.features;
  mesh.mesh = std::move(tiles);
}

bool LocalEdits::is_feature(const MeshEdge& edge) const {
  return std::any_of(mesh.features.begin(), mesh.features.end(), [&](const auto& pair) {
    return edge_key(pair[0], pair[1]) == edge_key(edge.v[0], edge.v[1]);
  });
}

bool LocalEdits::split(const MeshEdge& edge, const ClosestPoints& surface) {
  Points3& V = mesh.mesh.V;
  Triangles& F = mesh.mesh.F;
  const Vec3 middle = 0.5 * (V.row(edge.v[0]) + V.row(edge.v[1]));
  const bool feature = is_feature(edge);
  int course = -1;
  if (feature || edge.boundary()) {
    course = std::max(course_[edge.v[0]], course_[edge.v[1]]);  // borders come before creases
    if (edge.boundary()) course = std::min(course_[edge.v[0]], course_[edge.v[1]]);
    if (feature && course < borders_) return false;
  }
  const auto vertex = static_cast<int>(V.rows());
  V.conservativeResize(vertex + 1, 3);
  V.row(vertex) = course < 0 ? surface(middle).point : courses_[course].closest(middle);
  course_.push_back(course);
  knot_.push_back(0);
  gone_.push_back(0);
  mesh.fixed.push_back(0);
  for (int k = 0; k < (edge.boundary() ? 1 : 2); ++k) {
    const int f = edge.face[k], t = edge.side[k];
    const int b = F(f, next3(t)), c = F(f, prev3(t));
    F(f, next3(t)) = vertex;
    F.conservativeResize(F.rows() + 1, 3);
    F.row(F.rows() - 1) << vertex, b, c;
    row_.push_back(-1);
  }
  if (feature) {
    for (std::array<int, 2>& pair : mesh.features) {
      if (edge_key(pair[0], pair[1]) == edge_key(edge.v[0], edge.v[1])) pair = {edge.v[0], vertex};
    }
    mesh.features.push_back({vertex, edge.v[1]});
  }
  return true;
}

bool LocalEdits::collapse(const MeshEdge& edge, const ClosestPoints& surface) {
  Points3& V = mesh.mesh.V;
  Triangles& F = mesh.mesh.F;
  int kept = std::min(edge.v[0], edge.v[1]), removed = std::max(edge.v[0], edge.v[1]);
  const bool on_one_line = edge.boundary() || is_feature(edge);
  if (on_line(kept) && on_line(removed) && !on_one_line) return false;
  if (knot_[removed] || (on_line(removed) && !on_line(kept))) std::swap(kept, removed);
  if (knot_[removed] || (on_line(removed) && !on_line(kept))) return false;

  std::set<int> around[2];
  for (Eigen::Index f = 0; f < F.rows(); ++f) {
    for (int end = 0; end < 2; ++end) {
      if ((F.row(f).array() != edge.v[end]).all()) continue;
      for (int v : F.row(f)) around[end].insert(v);
    }
  }
  std::vector<int> common;  // with the edge's own vertices
  std::set_intersection(around[0].begin(), around[0].end(), around[1].begin(), around[1].end(),
                        std::back_inserter(common));
  if (common.size() != (edge.boundary() ? 3U : 4U)) return false;
  for (int v : common) {
    if (v == kept || v == removed) continue;
    Eigen::Index faces = 0;
    for (Eigen::Index f = 0; f < F.rows(); ++f) faces += (F.row(f).array() == v).any();
    const bool on_border = course_[v] >= 0 && course_[v] < borders_;
    if (faces < (on_border ? 2 : 4)) return false;
  }
  if (!knot_[kept] && on_line(kept) == on_line(removed)) {
    const Vec3 middle = 0.5 * (V.row(kept) + V.row(removed));
    V.row(kept) = on_line(kept) ? courses_[course_[kept]].closest(middle) : surface(middle).point;
  }
  gone_[removed] = 1;
  for (int& v : F.reshaped<Eigen::RowMajor>()) v = v == removed ? kept : v;
  for (std::array<int, 2>& pair : mesh.features) {
    for (int& v : pair) v = v == removed ? kept : v;
  }
  mesh.features.erase(std::remove_if(mesh.features.begin(), mesh.features.end(),
                                     [](const auto& pair) { return pair[0] == pair[1]; }),
                      mesh.features.end());
  return true;
}

void LocalEdits::drop_collapsed() {
  Triangles& F = mesh.mesh.F;
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < F.rows(); ++f) {
    if (F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0)) continue;
    const Eigen::RowVector3i face = F.row(f);
    F.row(count) = face;
    row_[count++] = row_[f];
  }
  F.conservativeResize(count, 3);
  row_.resize(count);
}

void LocalEdits::flip(const std::vector<char>& near) {
  for (int round = 0; round < flip_rounds; ++round) {
    std::vector<char> kept;
    for (Eigen::Index f = 0; f < mesh.mesh.F.rows(); ++f) {
      const auto face = mesh.mesh.F.row(f);
      kept.push_back(!near[face[0]] || !near[face[1]] || !near[face[2]]);
    }
    if (flip_towards_regular(mesh, kept) == 0) return;
  }
}

void LocalEdits::finish(const Triangles& before, FollowedMesh& out) const {
  std::vector<int> left, from;  // vertices that stay
  for (std::size_t v = 0; v < gone_.size(); ++v) {
    if (gone_[v]) continue;
    left.push_back(static_cast<int>(v));
    from.push_back(static_cast<int>(v) < before_ ? static_cast<int>(v) : -1);
  }
  const std::vector<int> number = numbers_of(from, before_);
  std::vector<int> new_of(gone_.size(), -1);
  out.mesh.V.resize(static_cast<Eigen::Index>(left.size()), 3);
  out.vertex_from.resize(left.size());
  for (std::size_t k = 0; k < left.size(); ++k) {
    new_of[left[k]] = number[k];
    out.mesh.V.row(number[k]) = mesh.mesh.V.row(left[k]);
    out.vertex_from[number[k]] = from[k];
  }
  const Triangles& F = mesh.mesh.F;
  const std::vector<int> rows = numbers_of(row_, static_cast<int>(before.rows()));
  out.mesh.F.resize(F.rows(), 3);
  out.tile_from.resize(rows.size());
  for (std::size_t f = 0; f < rows.size(); ++f) {
    const auto face = F.row(static_cast<Eigen::Index>(f));
    for (int t = 0; t < 3; ++t) out.mesh.F(rows[f], t) = new_of[face[t]];
    const bool same = row_[f] >= 0 && face == before.row(row_[f]);
    out.tile_from[rows[f]] = same ? row_[f] : -1;
  }
}

}  // namespace curveups
