// SPDX-License-Identifier: LGPL-2.1-or-later
// Built-in targets and functions of meshes.
#include "curveups/bindings/arrays.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/edge_paths.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"
#include "curveups/geometry/remesh.hpp"

namespace curveups::bindings {

void bind_geometry(py::module_& module) {
  module.def(
      "builtin_targets",
      [] {
        std::vector<std::pair<std::string, std::string>> list;
        for (const BuiltinTarget& t : builtin_targets()) list.emplace_back(t.name, t.meaning);
        return list;
      },
      "Names and one-line meanings of the built-in targets.");
  module.def(
      "builtin_target",
      [](const std::string& name, double tolerance) {
        TriangleMesh mesh = builtin_target(name, tolerance);
        return std::make_pair(std::move(mesh.V), std::move(mesh.F));
      },
      py::arg("name"), py::arg("tolerance") = 0.0035,
      "V and F of a fine triangulation within `tolerance` mm of the exact surface.");
  module.def(
      "mean_edge_length",
      [](const PointsIn& V, const TrianglesIn& F) { return mean_edge_length(read_mesh(V, F)); },
      py::arg("V"), py::arg("F"), "Mean length of the edges, mm.");
  module.def(
      "distances",
      [](const PointsIn& points, const PointsIn& V, const TrianglesIn& F) {
        const Points3 from = read_points(points, "points");
        const TriangleMesh mesh = read_mesh(V, F);
        const py::gil_scoped_release release;
        return distances(from, ClosestPoints(mesh));
      },
      py::arg("points"), py::arg("V"), py::arg("F"),
      "Distances of points from a surface, mm, one a point.");
  module.def(
      "closest_points",
      [](const PointsIn& points, const PointsIn& V, const TrianglesIn& F) {
        const Points3 from = read_points(points, "points");
        const TriangleMesh mesh = read_mesh(V, F);
        const py::gil_scoped_release release;
        const ClosestPoints closest(mesh);
        Points3 out(from.rows(), 3);
        for (Eigen::Index k = 0; k < from.rows(); ++k) out.row(k) = closest(from.row(k)).point;
        return out;
      },
      py::arg("points"), py::arg("V"), py::arg("F"),
      "The nearest points of a surface, one a point.");
  module.def(
      "surface_deviation",
      [](const PointsIn& V, const TrianglesIn& F, const PointsIn& target_V,
         const TrianglesIn& target_F, py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const TriangleMesh target = read_mesh(target_V, target_F, "target_V", "target_F");
        const Deviation d = without_gil(std::move(progress), [&](const Progress&) {
          checkpoint("measuring deviation");
          return surface_deviation(mesh, target);
        });
        return std::array<double, 3>{d.mean, d.max, d.hausdorff};
      },
      py::arg("V"), py::arg("F"), py::arg("target_V"), py::arg("target_F"),
      py::arg("progress") = py::none(),
      "Mean and largest distance from the target, and the Hausdorff distance, mm.");
  module.def(
      "shortest_edge_path",
      [](const PointsIn& V, const TrianglesIn& F, const PointsIn& points) {
        return shortest_edge_path(read_mesh(V, F), read_points(points, "points"));
      },
      py::arg("V"), py::arg("F"), py::arg("points"),
      "Vertices of the shortest edge path through those nearest to the points.");
  module.def(
      "conformal_map",
      [](const PointsIn& V, const TrianglesIn& F) {
        const TriangleMesh mesh = read_mesh(V, F);
        const py::gil_scoped_release release;
        return conformal_map(mesh);
      },
      py::arg("V"), py::arg("F"), "Flat positions of the vertices (spectral conformal map).");
  module.def(
      "triangulate_polygon",
      [](const PointsIn& points) { return triangulate_polygon(read_points(points, "points")); },
      py::arg("points"),
      "Triangles, as rows of points, of a plane polygon of any shape; none where it crosses "
      "itself.");
}

}  // namespace curveups::bindings
