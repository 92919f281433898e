// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/coarsen.hpp"

#include <algorithm>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/geometry/edge_sides.hpp"
#include "curveups/geometry/face_guard.hpp"

namespace curveups {
namespace {

constexpr int most_rounds = 40;

class Rounds {
 public:
  Rounds(const Points3& V, Triangles F, double length, std::vector<char> kept)
      : V_(V), F_(std::move(F)), longest_(length * length), kept_(std::move(kept)) {}

  // False where hardly anything was left to collapse.
  bool next();
  Triangles take() { return std::move(F_); }

 private:
  int find_target(int v, const std::vector<char>& locked);
  bool collapses(int v, int w);
  // Vertices of the faces at v, but for v itself; each once.
  const std::vector<int>& ring(int v, std::vector<int>& out) const;

  const Points3& V_;
  Triangles F_;
  double longest_;  // squared
  std::vector<char> kept_;
  std::vector<int> first_, face_at_;  // faces by vertex
  std::vector<int> ring_, other_;
};

const std::vector<int>& Rounds::ring(int v, std::vector<int>& out) const {
  out.clear();
  for (int i = first_[v]; i < first_[v + 1]; ++i) {
    for (int t = 0; t < 3; ++t) {
      const int w = F_(face_at_[i], t);
      if (w != v && std::find(out.begin(), out.end(), w) == out.end()) out.push_back(w);
    }
  }
  return out;
}

// Whether v can go to w: the two have two neighbours in common (the link condition inside), and all
// faces that stay are sound and look where they looked.
bool Rounds::collapses(int v, int w) {
  ring(w, other_);
  int common = 0;
  for (int u : ring_) common += std::find(other_.begin(), other_.end(), u) != other_.end();
  if (common != 2) return false;
  for (int u : ring_) {
    if (u != w && (V_.row(u) - V_.row(w)).squaredNorm() > longest_) return false;
  }
  constexpr double cosine = 0.7;
  for (int i = first_[v]; i < first_[v + 1]; ++i) {
    const int f = face_at_[i];
    Vec3 before[3], after[3];
    bool goes = false;
    for (int t = 0; t < 3; ++t) {
      const int u = F_(f, t);
      goes = goes || u == w;
      before[t] = V_.row(u);
      after[t] = V_.row(u == v ? w : u);
    }
    if (goes) continue;
    const Vec3 was = (before[1] - before[0]).cross(before[2] - before[0]);
    const Vec3 is = (after[1] - after[0]).cross(after[2] - after[0]);
    if (!(was.dot(is) > cosine * was.norm() * is.norm())) return false;
    if (soundness(after[0], after[1], after[2], is) < 0.1) return false;
  }
  return true;
}

// The nearest neighbour that v can go to, -1 where there is none.
int Rounds::find_target(int v, const std::vector<char>& locked) {
  ring(v, ring_);
  std::sort(ring_.begin(), ring_.end(), [&](int a, int b) {
    const double near = (V_.row(a) - V_.row(v)).squaredNorm();
    const double far = (V_.row(b) - V_.row(v)).squaredNorm();
    return near != far ? near < far : a < b;
  });
  for (int w : ring_) {
    if (!locked[w] && collapses(v, w)) return w;
  }
  return -1;
}

bool Rounds::next() {
  const int vertices = static_cast<int>(V_.rows()), faces = static_cast<int>(F_.rows());
  first_.assign(vertices + 1, 0);
  for (Eigen::Index c = 0; c < F_.size(); ++c) ++first_[F_.data()[c] + 1];
  for (int v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
  face_at_.resize(F_.size());
  std::vector<int> cursor(first_.begin(), first_.end() - 1);
  for (int f = 0; f < faces; ++f) {
    for (int t = 0; t < 3; ++t) face_at_[cursor[F_(f, t)]++] = f;
  }
  std::vector<char> locked(vertices, 0);  // a face there is no more what it was
  std::vector<char> gone(faces, 0);
  int collapsed = 0, left = 0;
  for (int v = 0; v < vertices; ++v) {
    checkpoint_now_and_then(v);
    if (first_[v] == first_[v + 1]) continue;
    ++left;
    if (kept_[v] || locked[v]) continue;
    const int w = find_target(v, locked);
    if (w < 0) continue;
    ++collapsed;
    for (int i = first_[v]; i < first_[v + 1]; ++i) {
      const int f = face_at_[i];
      for (int t = 0; t < 3; ++t) {
        gone[f] |= F_(f, t) == w;
        if (F_(f, t) == v) F_(f, t) = w;
      }
    }
    locked[v] = 1;
    for (int u : ring_) locked[u] = 1;
  }
  int kept_faces = 0;
  for (int f = 0; f < faces; ++f) {
    if (!gone[f]) F_.row(kept_faces++) = F_.row(f);
  }
  F_.conservativeResize(kept_faces, 3);
  return collapsed > left / 50;
}

}  // namespace

UsedPart coarsen(const TriangleMesh& mesh, double length, const std::vector<char>& kept) {
  std::vector<char> stays = kept;
  stays.resize(mesh.V.rows(), 0);
  visit_edges(mesh.F, static_cast<int>(mesh.V.rows()),
              [&](const EdgeSide* begin, const EdgeSide* end) {
                if (end - begin == 2) return;
                stays[begin->low] = stays[begin->high] = 1;
              });
  Rounds rounds(mesh.V, mesh.F, length, std::move(stays));
  for (int round = 0; round < most_rounds && rounds.next(); ++round) checkpoint();
  return used_part(mesh.V, rounds.take());
}

}  // namespace curveups
