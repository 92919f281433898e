// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/cgal_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups {

namespace {

using cgal::Mesh;

// The faces of slabs across the mesh's longest side, each in all that it reaches into: faces that
// have a point in common have one slab in common.
constexpr int slab_count = 8;
using Slabs = std::array<std::vector<Mesh::Face_index>, slab_count>;

Slabs divide(const TriangleMesh& mesh) {
  Eigen::Index axis = 0;
  (mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff()).maxCoeff(&axis);
  const auto along = [&](int f, int t) { return mesh.V(mesh.F(f, t), axis); };
  std::vector<double> place(mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) place[f] = along(f, 0);
  std::sort(place.begin(), place.end());
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::array<double, slab_count + 1> bound;
  for (int k = 1; k < slab_count; ++k) bound[k] = place[k * place.size() / slab_count];
  bound.front() = -infinite;
  bound.back() = infinite;
  Slabs slabs;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const auto [low, high] = std::minmax({along(f, 0), along(f, 1), along(f, 2)});
    for (int k = 0; k < slab_count; ++k) {
      if (high >= bound[k] && low <= bound[k + 1]) slabs[k].emplace_back(f);
    }
  }
  return slabs;
}

}  // namespace

std::vector<int> self_intersecting_faces(const TriangleMesh& mesh) {
  if (mesh.F.rows() == 0) return {};
  Mesh surface;
  const int refused = cgal::append(surface, mesh);
  if (refused >= 0) {
    throw TopologyError("the surface is not a manifold at face " + std::to_string(refused + 1),
                        "repair the file", {refused});
  }
  const Slabs slabs = divide(mesh);
  std::array<std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>>, slab_count> pairs;
  std::vector<std::function<void()>> tasks;
  for (int k = 0; k < slab_count; ++k) {
    tasks.emplace_back([&, k] {
      std::size_t asked = 0;
      CGAL::Polygon_mesh_processing::self_intersections(
          slabs[k], surface, std::back_inserter(pairs[k]),
          CGAL::parameters::vertex_point_map(cgal::WatchedPoints{&surface, &asked}));
    });
  }
  parallel_tasks(tasks);
  std::vector<int> found;
  for (const auto& of_slab : pairs) {
    for (const auto& [a, b] : of_slab) {
      found.push_back(static_cast<int>(a));
      found.push_back(static_cast<int>(b));
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace curveups
