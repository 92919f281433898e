// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/edge_sides.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "curveups/core/checkpoint.hpp"

namespace curveups {

void visit_edges(const Eigen::Ref<const Triangles>& F, int vertex_count,
                 const std::function<void(const EdgeSide* begin, const EdgeSide* end)>& visit) {
  const auto low_vertex = [&](int f, int t) { return std::min(F(f, t), F(f, next3(t))); };
  // Sorted by counting: the sides of low vertex v become [start[v], start[v + 1]).
  std::vector<int> start(vertex_count + 2, 0);
  for (int f = 0; f < F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) ++start[low_vertex(f, t) + 2];
  }
  for (int v = 2; v < vertex_count + 2; ++v) start[v] += start[v - 1];
  std::vector<EdgeSide> sides(3 * F.rows());
  for (int f = 0; f < F.rows(); ++f) {
    checkpoint_now_and_then(f);
    for (int t = 0; t < 3; ++t) {
      const int low = low_vertex(f, t), high = std::max(F(f, t), F(f, next3(t)));
      sides[start[low + 1]++] = {low, high, f, t, F(f, t) == low};
    }
  }
  for (int v = 0; v < vertex_count; ++v) {
    checkpoint_now_and_then(v);
    EdgeSide* at = sides.data() + start[v];
    EdgeSide* const last = sides.data() + start[v + 1];
    std::sort(at, last, [](const EdgeSide& a, const EdgeSide& b) {
      return std::tie(a.high, a.face, a.side) < std::tie(b.high, b.face, b.side);
    });
    while (at != last) {
      EdgeSide* next = at;
      while (next != last && next->high == at->high) ++next;
      if (at->high != v) visit(at, next);
      at = next;
    }
  }
}

}  // namespace curveups
