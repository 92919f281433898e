// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's AABB tree, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/closest_points.hpp"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/config.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else  // the names of before, without the dimension
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using TriangleList = std::vector<Triangle>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, TriangleList::const_iterator>;
using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, TriangleList::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
using Tree = CGAL::AABB_tree<Traits>;

Kernel::Point_3 point(const Points3& V, int v) { return {V(v, 0), V(v, 1), V(v, 2)}; }

}  // namespace

struct ClosestPoints::Impl {
  TriangleList triangles;
  Tree tree;
};

ClosestPoints::ClosestPoints(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  if (mesh.F.rows() == 0) throw InvalidInput("the surface has no faces", "check the input file");
  if (!mesh.V.allFinite()) {
    throw InvalidInput("the surface has a vertex that is not finite", "repair the file");
  }
  if (mesh.F.minCoeff() < 0 || mesh.F.maxCoeff() >= mesh.V.rows()) {
    throw InvalidInput("a face of the surface names a vertex that there is not", "repair the file");
  }
  impl_->triangles.reserve(mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    checkpoint_now_and_then(f);
    impl_->triangles.emplace_back(point(mesh.V, mesh.F(f, 0)), point(mesh.V, mesh.F(f, 1)),
                                  point(mesh.V, mesh.F(f, 2)));
  }
  checkpoint();
  impl_->tree.insert(impl_->triangles.begin(), impl_->triangles.end());
  const Traits& traits = impl_->tree.traits();
  std::size_t boxes = 0;
  impl_->tree.custom_build(
      traits.compute_bbox_object(),
      [&, split = traits.split_primitives_object()](auto first, auto beyond, const auto& box) {
        checkpoint_now_and_then(boxes++);
        split(first, beyond, box);
      });
  checkpoint();
  impl_->tree.accelerate_distance_queries();
}
ClosestPoints::~ClosestPoints() = default;
ClosestPoints::ClosestPoints(ClosestPoints&&) noexcept = default;
ClosestPoints& ClosestPoints::operator=(ClosestPoints&&) noexcept = default;

ClosestPoint ClosestPoints::operator()(const Vec3& query) const {
  const auto [found, triangle] =
      impl_->tree.closest_point_and_primitive(Kernel::Point_3(query.x(), query.y(), query.z()));
  const Vec3 at(found.x(), found.y(), found.z());
  return {at, static_cast<int>(triangle - impl_->triangles.cbegin()), (at - query).norm()};
}

double ClosestPoints::distance_to_face(const Vec3& query, int face) const {
  return std::sqrt(CGAL::squared_distance(Kernel::Point_3(query.x(), query.y(), query.z()),
                                          impl_->triangles[face]));
}

Vec3 ClosestPoints::normal(int face) const {
  const auto corner = [&](int k) {
    const Kernel::Point_3& p = impl_->triangles[face][k];
    return Vec3(p.x(), p.y(), p.z());
  };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

Eigen::VectorXd distances(const Points3& points, const ClosestPoints& surface) {
  Eigen::VectorXd distance(points.rows());
  parallel_ranges(static_cast<int>(points.rows()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) distance[i] = surface(points.row(i)).distance;
  });
  return distance;
}

double largest_distance(const Points3& points, const ClosestPoints& surface) {
  constexpr int stretch = 4096;  // of points, whatever the threads
  const int count = static_cast<int>(points.rows()), stretches = (count + stretch - 1) / stretch;
  std::vector<double> largest(stretches, 0);
  std::atomic<double> known{0};  // only spares work: what is skipped is below it
  parallel_ranges(stretches, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      checkpoint();
      int face = -1;
      for (int i = k * stretch; i < std::min(count, (k + 1) * stretch); ++i) {
        const Vec3 query = points.row(i);
        const double bound = std::max(largest[k], known.load());
        // A hair below, as the two distances are not rounded alike.
        if (face >= 0 && surface.distance_to_face(query, face) < (1 - 1e-9) * bound) continue;
        const ClosestPoint there = surface(query);
        face = there.face;
        largest[k] = std::max(largest[k], there.distance);
      }
      double before = known.load();
      while (largest[k] > before && !known.compare_exchange_weak(before, largest[k])) {
      }
    }
  });
  return count == 0 ? 0.0 : *std::max_element(largest.begin(), largest.end());
}

Points3 surface_samples(const TriangleMesh& mesh) {
  const int vertices = static_cast<int>(mesh.V.rows()), faces = static_cast<int>(mesh.F.rows());
  // In the order of build_topology, which refuses surfaces that are no manifolds.
  std::vector<std::array<int, 2>> pairs;
  std::unordered_set<std::uint64_t> seen;
  seen.reserve(2 * static_cast<std::size_t>(faces));
  for (int f = 0; f < faces; ++f) {
    checkpoint_now_and_then(f);
    for (int t = 0; t < 3; ++t) {
      const int a = mesh.F(f, t), b = mesh.F(f, next3(t));
      const auto low = static_cast<std::uint64_t>(std::min(a, b));
      if (seen.insert(low << 32 | static_cast<std::uint64_t>(std::max(a, b))).second) {
        pairs.push_back({a, b});
      }
    }
  }
  const int edges = static_cast<int>(pairs.size());
  Points3 samples(vertices + edges + faces, 3);
  samples.topRows(vertices) = mesh.V;
  for (int e = 0; e < edges; ++e) {
    samples.row(vertices + e) = 0.5 * (mesh.V.row(pairs[e][0]) + mesh.V.row(pairs[e][1]));
  }
  for (int f = 0; f < faces; ++f) {
    samples.row(vertices + edges + f) =
        (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
  }
  return samples;
}

Deviation surface_deviation(const TriangleMesh& mesh, const TriangleMesh& target) {
  const Eigen::VectorXd there = distances(surface_samples(mesh), ClosestPoints(target));
  const Eigen::VectorXd back = distances(surface_samples(target), ClosestPoints(mesh));
  return {there.mean(), there.maxCoeff(), std::max(there.maxCoeff(), back.maxCoeff())};
}

}  // namespace curveups
