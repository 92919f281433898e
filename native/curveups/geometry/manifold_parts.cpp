// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/manifold_parts.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygons = std::vector<std::vector<std::size_t>>;
namespace pmp = CGAL::Polygon_mesh_processing;

Polygons polygons_of(const TriangleMesh& mesh) {
  Polygons out(mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) out[f].push_back(static_cast<std::size_t>(mesh.F(f, t)));
  }
  return out;
}

}  // namespace

bool is_manifold(const TriangleMesh& mesh) {
  try {
    const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
    // Vertices that join several fans of faces come out as several.
    return static_cast<Eigen::Index>(cut_open(mesh, topology, {}).original.size()) == mesh.V.rows();
  } catch (const TopologyError&) {
    return false;
  }
}

int part_manifolds(TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    points.emplace_back(mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
  }
  Polygons polygons = polygons_of(mesh);
  pmp::orient_polygon_soup(points, polygons);
  const int before = static_cast<int>(mesh.V.rows()), after = static_cast<int>(points.size());
  TriangleMesh out{Points3(after, 3), Triangles(mesh.F.rows(), 3)};
  for (int v = 0; v < after; ++v) out.V.row(v) << points[v].x(), points[v].y(), points[v].z();
  std::vector<double> shortest(after, std::numeric_limits<double>::infinity());
  Points3 inwards = Points3::Zero(after, 3);
  for (int f = 0; f < out.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) out.F(f, t) = static_cast<int>(polygons[f][t]);
    for (int t = 0; t < 3; ++t) {
      const int a = out.F(f, t);
      for (int b : {out.F(f, next3(t)), out.F(f, prev3(t))}) {
        const Vec3 d = out.V.row(b) - out.V.row(a);
        shortest[a] = std::min(shortest[a], d.norm());
        inwards.row(a) += d;
      }
    }
  }
  for (int v = before; v < after; ++v) {
    const double size = inwards.row(v).norm();
    if (size > 0) out.V.row(v) += 1e-3 * shortest[v] / size * inwards.row(v);
  }
  mesh = std::move(out);
  return after - before;
}

}  // namespace curveups
