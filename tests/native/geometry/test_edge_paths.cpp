// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/edge_paths.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

TEST(EdgePaths, FollowTheShortestEdges) {
  const TriangleMesh mesh = test::flat_square(4, 4);
  Points3 points(3, 3);
  points << 0.1, 0.1, 1, 3.9, 0.2, 0, 4, 4.2, 0;
  const std::vector<int> path = shortest_edge_path(mesh, points);
  EXPECT_EQ(path, (std::vector<int>{0, 1, 2, 3, 4, 9, 14, 19, 24}));
  EXPECT_EQ(shortest_edge_path(mesh, points.topRows(1)), std::vector<int>{0});
}

TEST(EdgePaths, RefuseWhatCannotBeJoined) {
  TriangleMesh mesh;
  mesh.V.resize(6, 3);
  mesh.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0;
  mesh.F.resize(2, 3);
  mesh.F << 0, 1, 2, 3, 4, 5;
  Points3 points(2, 3);
  points << 0, 0, 0, 6, 0, 0;
  EXPECT_THROW(shortest_edge_path(mesh, points), TopologyError);
  EXPECT_THROW(shortest_edge_path(mesh, Points3(0, 3)), InvalidInput);
}

}  // namespace
}  // namespace curveups
