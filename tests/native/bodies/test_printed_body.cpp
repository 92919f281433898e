// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "curveups/bodies/printed_body.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

double shortest_edge(const ConvexBody& body) {
  double least = 1e300;
  for (const BodyFace& face : body.faces) {
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      const Vec3 &a = body.points[face.loop[k]],
                 &b = body.points[face.loop[(k + 1) % face.loop.size()]];
      least = std::min(least, (b - a).norm());
    }
  }
  return least;
}

bool closed(const ConvexBody& body) {
  std::map<std::pair<int, int>, int> edges;
  for (const BodyFace& face : body.faces) {
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      ++edges[{face.loop[k], face.loop[(k + 1) % face.loop.size()]}];
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

// Ripples of many heights: planes pass corners by all distances there are.
TEST(PrintedBody, HasNoShortEdgesAndLiesWithinTheTruncatedBody) {
  int shortened = 0, same = 0;
  for (int k = 0; k < 200; ++k) {
    const TileMesh tiles = make_tile_mesh(
        test::lifted_patch(8, 7,
                           [&](double x, double y) {
                             return 0.02 * k * std::sin(0.2 * x + k) * std::cos(0.17 * y);
                           }),
        Edges(0, 2), 3);
    const Truncation truncation = truncate_at_vertices(tiles);
    const std::array<double, 3> recess = {0.1 * (k % 3), 0.05 * (k % 3), 0};
    for (int i = 0; i < tiles.tile_count(); ++i) {
      const ConvexBody whole = tile_body(tiles, truncation, i, recess),
                       printed = printed_body(tiles, truncation, i, recess);
      if (shortest_edge(whole) >= least_cut) {
        same += volume(whole) == volume(printed);
        continue;
      }
      ++shortened;
      EXPECT_GT(shortest_edge(printed), 0.5 * least_cut) << k << " " << i;
      EXPECT_TRUE(closed(printed));
      EXPECT_LE(volume(printed), volume(whole) + 1e-9);
      EXPECT_GT(volume(printed), volume(whole) - 0.02);  // a cut of 10 mm2 moved by 2 least_cut
      for (const BodyFace& face : whole.faces) {
        for (const Vec3& p : printed.points) EXPECT_LT(face.plane.distance(p), 2e-5);
      }
      for (const BodyFace& face : printed.faces) {  // planar to what OpenCASCADE bears
        for (int p : face.loop) {
          EXPECT_LT(std::abs(face.plane.distance(printed.points[p])), 1.1e-5);
        }
      }
    }
  }
  EXPECT_GT(shortened, 20);
  EXPECT_GT(same, 1000);
}

}  // namespace
}  // namespace curveups
