// SPDX-License-Identifier: LGPL-2.1-or-later
// This file instantiates CGAL's 2D mesher, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/planar_mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_no_edge_refinement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct Label {
  int index = -1;  // in the mesh; -1 for points that the refinement has put in
};
using IndexedVertex = CGAL::Triangulation_vertex_base_with_info_2<Label, Kernel>;
using VertexBase = CGAL::Delaunay_mesh_vertex_base_2<Kernel, IndexedVertex>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_tag>;

// 20.6 degrees: circumradius to shortest edge sqrt(2), the bound up to which refinement provably
// ends. (The stock criterion bounds another quantity in CGAL 5.5.)
constexpr double squared_sine_bound = 0.125;

// CGAL's MeshingCriteria_2.
class GradedCriteria {
 public:
  // Too large goes before too flat, then the worst first.
  struct Quality {
    double oversize = 0;  // squared: longest edge over wanted size
    double squared_sine = 1;
    bool operator<(const Quality& other) const {
      if (oversize > 1 || other.oversize > 1) return oversize > other.oversize;
      return squared_sine < other.squared_sine;
    }
  };

  class Is_bad {  // NOLINT(readability-identifier-naming): the name is CGAL's
   public:
    explicit Is_bad(const std::function<double(const Vec2&)>* size) : size_(size) {}
    CGAL::Mesh_2::Face_badness operator()(const Quality& q) const {
      if (q.oversize > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return q.squared_sine < squared_sine_bound ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(Triangulation::Face_handle face, Quality& q) const {
      const auto &a = face->vertex(0)->point(), &b = face->vertex(1)->point(),
                 &c = face->vertex(2)->point();
      const Vec2 pa(a.x(), a.y()), pb(b.x(), b.y()), pc(c.x(), c.y());
      std::array<double, 3> sq = {(pb - pc).squaredNorm(), (pc - pa).squaredNorm(),
                                  (pa - pb).squaredNorm()};
      std::sort(sq.begin(), sq.end());
      const double wanted = (*size_)((pa + pb + pc) / 3), doubled_area = wedge(pb - pa, pc - pa);
      q.oversize = sq[2] / (wanted * wanted);
      // The smallest angle lies between the two longer edges.
      q.squared_sine = doubled_area * doubled_area / (sq[1] * sq[2]);
      return operator()(q);
    }

   private:
    const std::function<double(const Vec2&)>* size_;
  };

  explicit GradedCriteria(const std::function<double(const Vec2&)>* size) : size_(size) {}
  Is_bad is_bad_object() const { return Is_bad(size_); }

 private:
  const std::function<double(const Vec2&)>* size_;
};

Kernel::Point_2 to_cgal(const Vec2& p) { return {p.x(), p.y()}; }

}  // namespace

bool is_simple_polygon(const std::vector<Vec2>& boundary) {
  std::vector<Kernel::Point_2> corners;
  for (const Vec2& p : boundary) {
    if (!p.allFinite()) return false;
    corners.push_back(to_cgal(p));
  }
  return area(boundary) > 0 && CGAL::is_simple_2(corners.begin(), corners.end(), Kernel());
}

PlanarMesh mesh_polygon(const std::vector<Vec2>& boundary,
                        const std::function<double(const Vec2&)>& size) {
  if (!is_simple_polygon(boundary)) {
    throw InvalidInput("a polygon to be meshed is not simple and counter-clockwise",
                       "give corners in order, without crossings");
  }
  const std::size_t count = boundary.size();
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> corner;
  for (std::size_t i = 0; i < count; ++i) {
    corner.push_back(triangulation.insert(to_cgal(boundary[i])));
    corner[i]->info().index = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    triangulation.insert_constraint(corner[i], corner[(i + 1) % count]);
  }
  CGAL::Delaunay_mesher_no_edge_refinement_2<Triangulation, GradedCriteria> mesher(
      triangulation, GradedCriteria(&size));
  mesher.refine_mesh();

  PlanarMesh mesh;
  mesh.points = boundary;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v) {
    if (v->info().index >= 0) continue;
    v->info().index = static_cast<int>(mesh.points.size());
    mesh.points.push_back({v->point().x(), v->point().y()});
  }
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (!f->is_in_domain()) continue;
    mesh.triangles.push_back(
        {f->vertex(0)->info().index, f->vertex(1)->info().index, f->vertex(2)->info().index});
  }
  return mesh;
}

}  // namespace curveups
