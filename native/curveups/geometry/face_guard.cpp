// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/face_guard.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Faces for which `wrong` is true, ascending.
template <class Wrong>
std::vector<int> faces_where(const Triangles& F, const Wrong& wrong) {
  std::vector<char> marked(F.rows(), 0);
  parallel_ranges(static_cast<int>(F.rows()), [&](int begin, int end) {
    for (int f = begin; f < end; ++f) marked[f] = wrong(f);
  });
  std::vector<int> out;
  for (int f = 0; f < F.rows(); ++f) {
    if (marked[f]) out.push_back(f);
  }
  return out;
}

}  // namespace

double soundness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (!(longest > 0)) return 0;
  const Vec3 area = (b - a).cross(c - a);
  const double size = normal.norm();
  return (size > 0 ? area.dot(normal) / size : area.norm()) / longest;
}

double soundness(const SurfacePoints& points, const Triangles& F, int face) {
  const int a = F(face, 0), b = F(face, 1), c = F(face, 2);
  const Vec3 normal = points.normal.row(a) + points.normal.row(b) + points.normal.row(c);
  return soundness(points.V.row(a), points.V.row(b), points.V.row(c), normal);
}

std::vector<int> unsound_faces(const SurfacePoints& points, const Triangles& F) {
  return faces_where(F, [&](int f) { return soundness(points, F, f) < least_soundness; });
}

void cut_short(const Triangles& F, const SurfacePoints& before, SurfacePoints& after,
               const ClosestPoints& surface) {
  constexpr double least_share = 0.1;  // of a move, below which it is left out
  std::vector<double> share;
  // Shares only get smaller, and faces none of whose vertices moves are as they were: it ends.
  for (;;) {
    const std::vector<int> spoiled = faces_where(F, [&](int f) {
      const double now = soundness(after, F, f);
      return now < least_soundness && now < soundness(before, F, f);
    });
    if (spoiled.empty()) return;
    if (share.empty()) share.assign(before.V.rows(), 1);
    std::vector<int> vertices;
    for (int f : spoiled) vertices.insert(vertices.end(), F.data() + 3 * f, F.data() + 3 * f + 3);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (int v : vertices) {
      share[v] *= 0.5;
      if (share[v] < least_share || after.V.row(v) == before.V.row(v)) {
        share[v] = 0;  // the normal stays too: at an edge the same point may have another
        after.V.row(v) = before.V.row(v);
        after.normal.row(v) = before.normal.row(v);
        continue;
      }
      const Vec3 half = 0.5 * (before.V.row(v) + after.V.row(v));
      const ClosestPoint there = surface(half);
      after.V.row(v) = there.point;
      after.normal.row(v) = surface.normal(there.face);
    }
  }
}

}  // namespace curveups
