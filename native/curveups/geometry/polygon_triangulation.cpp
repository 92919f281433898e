// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/polygon_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

struct FaceLabel {
  int parity = -1;  // 1 inside an odd number of loops, -1 while unknown
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using PlainFace = CGAL::Triangulation_face_base_with_info_2<FaceLabel, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, PlainFace>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_tag>;

[[noreturn]] void refuse() {
  throw TopologyError("the outlines of a plane face cross or touch each other",
                      "check the layout for bodies that overlap");
}

// Parity of the loops around each face, by a flood from outside: every constrained edge changes it.
void mark_parities(Triangulation& cdt) {
  std::vector<Triangulation::Face_handle> front{cdt.infinite_face()};
  front[0]->info().parity = 0;
  while (!front.empty()) {
    const Triangulation::Face_handle face = front.back();
    front.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Triangulation::Face_handle other = face->neighbor(i);
      if (other->info().parity >= 0) continue;
      other->info().parity = face->info().parity ^ (face->is_constrained(i) ? 1 : 0);
      front.push_back(other);
    }
  }
}

}  // namespace

std::vector<std::array<int, 3>> triangulate_region(const std::vector<Vec2>& points,
                                                   const std::vector<std::vector<int>>& loops) {
  Triangulation cdt;
  std::vector<Triangulation::Vertex_handle> vertex(points.size());
  std::size_t used = 0;
  Triangulation::Face_handle hint;
  for (const std::vector<int>& loop : loops) {
    if (loop.size() < 3) refuse();
    for (int i : loop) {
      if (vertex[i] != Triangulation::Vertex_handle() || !points[i].allFinite()) refuse();
      vertex[i] = cdt.insert(Kernel::Point_2(points[i].x(), points[i].y()), hint);
      vertex[i]->info() = i;
      hint = vertex[i]->face();
      ++used;
    }
  }
  if (cdt.number_of_vertices() != used) refuse();
  try {
    for (const std::vector<int>& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        cdt.insert_constraint(vertex[loop[k]], vertex[loop[(k + 1) % loop.size()]]);
      }
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    refuse();
  }
  // CGAL splits an edge that passes through a corner.
  for (const std::vector<int>& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (!cdt.is_edge(vertex[loop[k]], vertex[loop[(k + 1) % loop.size()]])) refuse();
    }
  }
  mark_parities(cdt);
  std::vector<std::array<int, 3>> triangles;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    if (face->info().parity == 0) continue;
    triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return triangles;
}

std::vector<std::array<int, 3>> triangulate_polygon(const Points3& corners) {
  const int count = static_cast<int>(corners.rows());
  if (count < 3) return {};
  Vec3 normal = Vec3::Zero();
  for (int i = 1; i + 1 < count; ++i) {
    const Vec3 a = corners.row(i) - corners.row(0), b = corners.row(i + 1) - corners.row(0);
    normal += a.cross(b);
  }
  if (!(normal.norm() > 0)) return {};
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(normal, Vec3::UnitZ()).toRotationMatrix();
  std::vector<Vec2> flat(count);
  std::vector<int> loop(count);
  for (int i = 0; i < count; ++i) {
    flat[i] = (turn * (corners.row(i) - corners.row(0)).transpose()).head<2>();
    loop[i] = i;
  }
  try {
    return triangulate_region(flat, {loop});
  } catch (const TopologyError&) {
    return {};
  }
}

}  // namespace curveups
