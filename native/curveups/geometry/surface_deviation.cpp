// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/surface_deviation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/closest_points.hpp"

namespace curveups {
namespace {

using Corners = std::array<Vec3, 3>;

// Calls visit(centroid, area) for each part of the triangle, whose edges are no longer than `step`.
template <class Visit>
void visit_parts(const Corners& triangle, double step, const Visit& visit) {
  int longest = 0;
  double length = 0;
  for (int t = 0; t < 3; ++t) {
    const double own = (triangle[next3(t)] - triangle[t]).norm();
    if (own > length) longest = t, length = own;
  }
  const Vec3 &a = triangle[longest], &b = triangle[next3(longest)], &c = triangle[prev3(longest)];
  if (length <= step) {
    visit((a + b + c) / 3, 0.5 * (b - a).cross(c - a).norm());
    return;
  }
  const Vec3 middle = 0.5 * (a + b);
  visit_parts({a, middle, c}, step, visit);
  visit_parts({middle, b, c}, step, visit);
}

// Mean length of the faces' sides; inner edges count twice.
double mean_side(const TriangleMesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) {
      sum += (mesh.V.row(mesh.F(f, next3(t))) - mesh.V.row(mesh.F(f, t))).norm();
    }
  }
  return sum / (3.0 * static_cast<double>(mesh.F.rows()));
}

double step_between(const TriangleMesh& a, const TriangleMesh& b) {
  return sample_step * std::max(mean_side(a), mean_side(b));
}

struct Sums {
  double area = 0, distance = 0, square = 0;  // integrals of the distance over the area
  double largest = 0;
};

Sums sample(const TriangleMesh& mesh, const ClosestPoints& surface, double step) {
  const int faces = static_cast<int>(mesh.F.rows());
  const Eigen::VectorXd of_vertex = distances(mesh.V, surface);
  std::vector<Sums> of_face(faces);
  parallel_for(faces, [&](int f) {
    checkpoint();
    Sums& sums = of_face[f];
    Corners corners;
    for (int t = 0; t < 3; ++t) {
      corners[t] = mesh.V.row(mesh.F(f, t));
      sums.largest = std::max(sums.largest, of_vertex[mesh.F(f, t)]);
    }
    visit_parts(corners, step, [&](const Vec3& at, double area) {
      const double distance = surface(at).distance;
      sums.area += area;
      sums.distance += area * distance;
      sums.square += area * distance * distance;
      sums.largest = std::max(sums.largest, distance);
    });
  });
  Sums all;
  for (const Sums& sums : of_face) {
    all.area += sums.area;
    all.distance += sums.distance;
    all.square += sums.square;
    all.largest = std::max(all.largest, sums.largest);
  }
  return all;
}

}  // namespace

double largest_distance(const TriangleMesh& mesh, const TriangleMesh& surface) {
  const ClosestPoints closest(surface);
  return sample(mesh, closest, step_between(mesh, surface)).largest;
}

Deviation surface_deviation(const TriangleMesh& mesh, const TriangleMesh& target) {
  const ClosestPoints to(target), from(mesh);
  const double step = step_between(mesh, target);
  // CAD parts have few large faces: the mesh's own size limits the step.
  const Sums forth = sample(mesh, to, std::min(step, 0.25 * mean_side(mesh)));
  const Sums back = sample(target, from, step);
  Deviation out;
  if (forth.area > 0) {
    out.mean = forth.distance / forth.area;
    out.rms = std::sqrt(forth.square / forth.area);
  }
  out.max = forth.largest;
  out.hausdorff = std::max(forth.largest, back.largest);
  return out;
}

}  // namespace curveups
