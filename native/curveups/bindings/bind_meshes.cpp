// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes: built-in targets, mending and remeshing, distances, pieces.
#include "curveups/bindings/arrays.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/divide_surface.hpp"
#include "curveups/geometry/edge_paths.hpp"
#include "curveups/geometry/follow_mesh.hpp"
#include "curveups/geometry/mend_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"
#include "curveups/geometry/registration.hpp"
#include "curveups/geometry/remesh.hpp"
#include "curveups/geometry/surface_deviation.hpp"

namespace curveups::bindings {
namespace {

std::pair<Points3, Eigen::VectorXi> closest_points(const NumbersIn& points, const NumbersIn& V,
                                                   const IndicesIn& F) {
  const Points3 from = read_points(points, "points");
  const ClosestPoints closest(read_mesh(V, F));
  std::pair<Points3, Eigen::VectorXi> out{Points3(from.rows(), 3), Eigen::VectorXi(from.rows())};
  parallel_ranges(static_cast<int>(from.rows()), [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const ClosestPoint nearest = closest(from.row(k));
      out.first.row(k) = nearest.point;
      out.second(k) = nearest.face;
    }
  });
  return out;
}

// A class of a result whose `mesh` is V and F.
template <class Result>
py::class_<Result> bind_mesh(py::module_& module, const char* name, const char* doc) {
  return py::class_<Result>(module, name, doc)
      .def_property_readonly("V", [](const Result& result) { return result.mesh.V; })
      .def_property_readonly("F", [](const Result& result) { return result.mesh.F; });
}

MeshTopology cut_topology(const CutMesh& target) { return build_topology(target.mesh.F); }

}  // namespace

void bind_meshes(py::module_& module) {
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
      [](const NumbersIn& V, const IndicesIn& F) { return mean_edge_length(read_mesh(V, F)); },
      py::arg("V"), py::arg("F"), "Mean length of the edges, mm.");
  module.def(
      "distances",
      [](const NumbersIn& points, const NumbersIn& V, const IndicesIn& F) {
        const Points3 from = read_points(points, "points");
        const TriangleMesh mesh = read_mesh(V, F);
        return distances(from, ClosestPoints(mesh));
      },
      py::arg("points"), py::arg("V"), py::arg("F"), Released(),
      "Distances of points from a surface, mm, one a point.");
  module.def("closest_points", &closest_points, py::arg("points"), py::arg("V"), py::arg("F"),
             Released(),
             "The nearest points of a surface, one a point, and their faces (rows of F).");
  py::class_<Registration>(module, "Registration", "x -> R x + t lays a scanned point.")
      .def_property_readonly("R", [](const Registration& r) { return r.pose.R; })
      .def_property_readonly("t", [](const Registration& r) { return r.pose.t; })
      .def_readonly("noise", &Registration::noise)
      .def_readonly("loss_scale", &Registration::loss_scale)
      .def_readonly("rotation_deviation", &Registration::rotation_deviation)
      .def_readonly("translation_deviation", &Registration::translation_deviation)
      .def_readonly("other_turns", &Registration::other_turns);
  module.def(
      "register_scan",
      [](const NumbersIn& points, const NumbersIn& V, const IndicesIn& F, double tile,
         const Progress& progress) {
        const Points3 from = read_points(points, "points");
        const TriangleMesh mesh = read_mesh(V, F);
        require_positive(tile, "tile");
        const ProgressScope scope(progress);
        return register_scan(from, mesh, tile);
      },
      py::arg("points"), py::arg("V"), py::arg("F"), py::arg("tile"),
      py::arg("progress") = py::none(), Released(),
      "Lays scanned points onto a surface of tiles so large, mm.");
  module.def(
      "register_markers",
      [](const NumbersIn& points, const NumbersIn& targets) {
        const Points3 from = read_points(points, "points"), to = read_points(targets, "targets");
        if (from.rows() != to.rows()) {
          throw InvalidInput("there are not as many targets as points", "give one a point");
        }
        return register_markers(from, to);
      },
      py::arg("points"), py::arg("targets"), Released(), "Lays points onto targets, one a point.");
  FiguresClass<Deviation>(module, "Deviation", "Distances of a surface from a target, mm.")
      .figure("mean_mm", &Deviation::mean)
      .figure("rms_mm", &Deviation::rms)
      .figure("max_mm", &Deviation::max)
      .figure("hausdorff_mm", &Deviation::hausdorff);
  module.def(
      "surface_deviation",
      [](const NumbersIn& V, const IndicesIn& F, const NumbersIn& target_V,
         const IndicesIn& target_F, const Progress& progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const TriangleMesh target = read_mesh(target_V, target_F, "target_V", "target_F");
        const ProgressScope scope(progress);
        checkpoint("measuring deviation");
        return surface_deviation(mesh, target);
      },
      py::arg("V"), py::arg("F"), py::arg("target_V"), py::arg("target_F"),
      py::arg("progress") = py::none(), Released(), "Distances of a surface from a target.");
  module.def(
      "shortest_edge_path",
      [](const NumbersIn& V, const IndicesIn& F, const NumbersIn& points) {
        return shortest_edge_path(read_mesh(V, F), read_points(points, "points"));
      },
      py::arg("V"), py::arg("F"), py::arg("points"),
      "Vertices of the shortest edge path through those nearest to the points.");
  module.def(
      "conformal_map",
      [](const NumbersIn& V, const IndicesIn& F) {
        const TriangleMesh mesh = read_mesh(V, F);
        return conformal_map(mesh);
      },
      py::arg("V"), py::arg("F"), Released(),
      "Flat positions of the vertices (spectral conformal map).");
  module.def(
      "triangulate_polygon",
      [](const NumbersIn& points) { return triangulate_polygon(read_points(points, "points")); },
      py::arg("points"),
      "Triangles, as rows of points, of a plane polygon of any shape; none where it crosses "
      "itself.");

  bind_mesh<CleanMesh>(module, "CleanMesh", "A repaired mesh and notes on it.")
      .def_readonly("notes", &CleanMesh::notes);
  module.def(
      "clean_mesh",
      [](const NumbersIn& V, const IndicesIn& F, const Progress& progress) {
        const TriangleMesh soup = read_unchecked_mesh(V, F);
        const ProgressScope scope(progress);
        return clean_mesh(soup);
      },
      py::arg("V"), py::arg("F"), py::arg("progress") = py::none(), Released(),
      "Merges vertices, removes degenerate and doubled faces, makes the orientation consistent.");

  module.def(
      "check_mesh",
      [](const NumbersIn& V, const IndicesIn& F, double L, bool cuts_given,
         const Progress& progress, bool without_crossings) {
        require_positive(L, "L");
        const TriangleMesh mesh = read_unchecked_mesh(V, F);
        const ProgressScope scope(progress);
        return check_mesh(mesh, L, cuts_given, without_crossings);
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("cuts_given") = false,
      py::arg("progress") = py::none(), py::arg("without_crossings") = false, Released(),
      "Obstacles and warnings of a surface. without_crossings: do not search for faces that run "
      "through one another, as none is known to.");

  bind_mesh<MendedMesh>(module, "MendedMesh", "A mesh that can be remeshed, and how it was mended.")
      .def_readonly("actions", &MendedMesh::actions)
      .def_readonly("without_crossings", &MendedMesh::without_crossings);
  module.def(
      "mend_mesh",
      [](const NumbersIn& V, const IndicesIn& F, double L, double hole_edge,
         const Progress& progress) {
        const TriangleMesh mesh = read_unchecked_mesh(V, F);
        const ProgressScope scope(progress);
        return mend_mesh(mesh, {L, hole_edge});
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("hole_edge"),
      py::arg("progress") = py::none(), Released(),
      "Takes non-manifold parts apart, removes crumbs and small intersections, fills holes whose "
      "edge is shorter than hole_edge mm.");

  bind_mesh<RemeshResult>(module, "RemeshResult", "A uniform triangulation and its figures.")
      .def_readonly("mean_edge", &RemeshResult::mean_edge)
      .def_readonly("edge_cv", &RemeshResult::edge_cv)
      .def_readonly("chord_error", &RemeshResult::chord_error)
      .def_readonly("features", &RemeshResult::features);

  module.def(
      "remesh",
      [](const NumbersIn& V, const IndicesIn& F, double L, const Progress& progress,
         double crease_angle, const IndicesIn& features, double corner_reach) {
        constexpr double degree = 3.14159265358979323846 / 180;
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges lines = read_edges(features, mesh.V.rows(), "features");
        const ProgressScope scope(progress);
        return remesh(mesh, {L, crease_angle * degree, lines, corner_reach});
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("progress") = py::none(), Released(),
      py::arg("crease_angle") = 180.0,
      py::arg("features") = IndicesIn(std::vector<py::ssize_t>{0, 2}),
      py::arg("corner_reach") = 0.0,
      "Uniform isotropic triangulation of mean edge length L mm; creases above crease_angle "
      "(degrees) and features (vertex pairs) stay edges; corners of the boundary are found by its "
      "course within corner_reach mm.");

  bind_mesh<FollowedMesh>(module, "FollowedMesh", "A tiling on a changed surface.")
      .def_readonly("obstacle", &FollowedMesh::obstacle)
      .def_property_readonly("tile_from",
                             [](const FollowedMesh& f) { return py::array(py::cast(f.tile_from)); })
      .def_property_readonly(
          "vertex_from", [](const FollowedMesh& f) { return py::array(py::cast(f.vertex_from)); })
      .def_readonly("mean_edge", &FollowedMesh::mean_edge)
      .def_readonly("edge_cv", &FollowedMesh::edge_cv)
      .def_readonly("chord_error", &FollowedMesh::chord_error);
  module.def(
      "follow_mesh",
      [](const NumbersIn& tiles_V, const IndicesIn& tiles_F, const NumbersIn& V, const IndicesIn& F,
         double L, double crease_angle, const std::optional<IndicesIn>& features,
         const Progress& progress) {
        constexpr double degree = 3.14159265358979323846 / 180;
        const TriangleMesh tiles = read_mesh(tiles_V, tiles_F, "tiles_V", "tiles_F");
        const TriangleMesh surface = read_mesh(V, F);
        FollowOptions options{L, crease_angle * degree};
        if (features) options.features = read_edges(*features, surface.V.rows(), "features");
        const ProgressScope scope(progress);
        return follow_mesh(tiles, surface, options);
      },
      py::arg("tiles_V"), py::arg("tiles_F"), py::arg("V"), py::arg("F"), py::arg("L"),
      py::arg("crease_angle") = 180.0, py::arg("features") = py::none(),
      py::arg("progress") = py::none(), Released(),
      "Carries tiles along to a changed surface. features: its creases, vertex pairs; None: edges "
      "that bend by more than crease_angle (degrees). obstacle: why it needs new tiles, or empty; "
      "tile_from: per tile the old tile of the same vertices, or -1; vertex_from likewise.");

  py::class_<SurfaceDivision>(module, "SurfaceDivision", "A surface in pieces that can lie flat.")
      .def_property_readonly("piece",
                             [](const SurfaceDivision& d) { return py::array(py::cast(d.piece)); })
      .def_readonly("borders", &SurfaceDivision::borders)
      .def_readonly("slits", &SurfaceDivision::slits);
  module.def(
      "divide_surface",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts, int count,
         const Progress& progress) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        const ProgressScope scope(progress);
        checkpoint("dividing into pieces");
        const MeshTopology topology = cut_topology(target);
        return divide_surface(target.mesh, topology, mark_cuts(topology, target.cuts), count);
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("count"),
      py::arg("progress") = py::none(), Released(),
      "Divides a mesh that is cut along `cuts` into `count` pieces: the piece of each face, the "
      "edges between pieces, and the slits inside of them that let each lie flat.");
  module.def(
      "pieces_of_faces",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        const MeshTopology topology = cut_topology(target);
        return py::array(py::cast(pieces_of_faces(topology, mark_cuts(topology, target.cuts))));
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"),
      "The piece of each face of a mesh that is cut along `cuts`, from 0 in the order of the "
      "lowest faces.");
}

}  // namespace curveups::bindings
