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
#include <cmath>
#include <vector>

#include "curveups/core/checkpoint.hpp"
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
  Vec3 corner(int face, int k) const {
    const Kernel::Point_3& p = triangles[face][k];
    return {p.x(), p.y(), p.z()};
  }
  TriangleList triangles;
  Tree tree;
};

ClosestPoints::ClosestPoints(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
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

ClosestPoint ClosestPoints::operator()(const Vec3& query) const {
  const auto [nearest, triangle] =
      impl_->tree.closest_point_and_primitive(Kernel::Point_3(query.x(), query.y(), query.z()));
  const Vec3 at(nearest.x(), nearest.y(), nearest.z());
  return {at, static_cast<int>(triangle - impl_->triangles.cbegin()), (at - query).norm()};
}

Vec3 ClosestPoints::normal(int face) const {
  const Vec3 a = impl_->corner(face, 0), b = impl_->corner(face, 1), c = impl_->corner(face, 2);
  return (b - a).cross(c - a).normalized();
}

Eigen::VectorXd distances(const Points3& points, const ClosestPoints& surface) {
  Eigen::VectorXd distance(points.rows());
  parallel_for(static_cast<int>(points.rows()), [&](int i) {
    checkpoint();
    distance[i] = surface(points.row(i)).distance;
  });
  return distance;
}

}  // namespace curveups
