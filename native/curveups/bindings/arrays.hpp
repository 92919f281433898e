// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of arrays that Python hands in. pybind11 refuses other kinds of numbers (TypeError); these
// functions refuse other shapes, values that are not finite and vertices that do not exist: they
// throw InvalidInput, which names the array. They change no reference counts and need no GIL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "curveups/bindings/bindings.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups::bindings {

using NumbersIn = py::array_t<double, py::array::c_style>;
using IndicesIn = py::array_t<std::int64_t, py::array::c_style>;

// N x 3, finite and within tolerance::largest_coordinate.
Points3 read_points(const NumbersIn& points, const char* name);
// V: N x 3, F: M x 3.
TriangleMesh read_mesh(const NumbersIn& V, const IndicesIn& F, const char* V_name = "V",
                       const char* F_name = "F");
// Input of check_mesh and of what mends meshes: shapes are checked, values are not.
TriangleMesh read_unchecked_mesh(const NumbersIn& V, const IndicesIn& F);
// C x 2 vertices.
Edges read_edges(const IndicesIn& edges, Eigen::Index vertex_count, const char* name);
// M x a x b as M x 6, a b = 6.
Array6 read_blocks(const NumbersIn& blocks, const char* name, int a, int b);
// Rows of F, and pairs of them.
void require_tiles(const std::vector<int>& tiles, Eigen::Index tile_count, const char* name);
void require_tiles(const std::vector<std::array<int, 2>>& pairs, Eigen::Index tile_count,
                   const char* name);
// Finite and greater than 0.
void require_positive(double value, const char* name);

// A mesh and the edges along which it is cut.
struct CutMesh {
  TriangleMesh mesh;
  Edges cuts;
};
CutMesh read_cut_mesh(const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts);

}  // namespace curveups::bindings
