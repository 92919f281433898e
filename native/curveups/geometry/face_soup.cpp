// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/face_soup.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "curveups/core/checkpoint.hpp"

namespace curveups {

void visit_edges(const Eigen::Ref<const Triangles>& F,
                 const std::function<void(const EdgeSide* begin, const EdgeSide* end)>& visit) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * F.rows());
  for (int f = 0; f < F.rows(); ++f) {
    checkpoint_now_and_then(f);
    for (int t = 0; t < 3; ++t) {
      const auto [low, high] = std::minmax({F(f, t), F(f, next3(t))});
      if (low != high) sides.push_back({low, high, f, t, F(f, t) == low});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.face, a.side) < std::tie(b.low, b.high, b.face, b.side);
  });
  const EdgeSide* const last = sides.data() + sides.size();
  for (const EdgeSide *at = sides.data(), *next = at; at != last; at = next) {
    checkpoint_now_and_then(at - sides.data());
    while (next != last && next->low == at->low && next->high == at->high) ++next;
    visit(at, next);
  }
}

std::vector<int> repeated_faces(const Eigen::Ref<const Triangles>& F) {
  std::vector<int> repeated;
  const auto visit = [&](const EdgeSide* begin, const EdgeSide* end) {
    if (end - begin < 2) return;
    std::set<int> thirds;  // corners beside the edge, where it is the face's lowest one
    for (const EdgeSide* side = begin; side != end; ++side) {
      const int third = F(side->face, prev3(side->side));
      if (third > side->high && !thirds.insert(third).second) repeated.push_back(side->face);
    }
  };
  visit_edges(F, visit);
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

Orientation orientation_of(const Points3& V, const Eigen::Ref<const Triangles>& F) {
  const int face_count = static_cast<int>(F.rows());
  Triangles across = Triangles::Constant(face_count, 3, -1);  // the face at each side
  std::vector<std::array<char, 3>> alike(face_count);  // runs along that side in the same direction
  visit_edges(F, [&](const EdgeSide* begin, const EdgeSide* end) {
    if (end - begin != 2) return;
    for (int k = 0; k < 2; ++k) {
      across(begin[k].face, begin[k].side) = begin[1 - k].face;
      alike[begin[k].face][begin[k].side] = begin[0].up == begin[1].up;
    }
  });
  Orientation out;
  out.turn.assign(face_count, 0);
  std::vector<char> seen(face_count, 0);
  std::vector<int> part;
  std::size_t done = 0;
  for (int seed = 0; seed < face_count; ++seed) {
    if (seen[seed]) continue;
    part.assign(1, seed);
    seen[seed] = 1;
    double area[2] = {0, 0};
    for (std::size_t i = 0; i < part.size(); ++i) {
      checkpoint_now_and_then(done++);
      const int f = part[i];
      const Vec3 a = V.row(F(f, 0)), b = V.row(F(f, 1)), c = V.row(F(f, 2));
      area[out.turn[f] ? 1 : 0] += (b - a).cross(c - a).norm();
      for (int t = 0; t < 3; ++t) {
        const int g = across(f, t);
        if (g < 0) continue;
        const char turn = static_cast<char>(out.turn[f] != alike[f][t]);
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

}  // namespace curveups
