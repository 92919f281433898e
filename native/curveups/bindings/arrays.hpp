// SPDX-License-Identifier: LGPL-2.1-or-later
// The one place where arrays that Python hands in are checked. A binding takes them as the types
// below, which accept any object, and reads them here, with the GIL held: what comes out is finite
// and names vertices that there are. All functions throw InvalidInput, naming the array.
#pragma once

#include <array>
#include <vector>

#include "curveups/bindings/bindings.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups::bindings {

struct PointsIn {  // N x 3 numbers
  py::object given;
};
struct TrianglesIn {  // M x 3 integers
  py::object given;
};
struct EdgesIn {  // C x 2 integers
  py::object given;
};
struct BlocksIn {  // M x a x b numbers
  py::object given;
};

// Whole and finite, and within what double precision can place (1e8 mm).
Points3 read_points(const PointsIn& points, const char* name);
TriangleMesh read_mesh(const PointsIn& V, const TrianglesIn& F, const char* V_name = "V",
                       const char* F_name = "F");
// What checks are to tell of: of the right shape and kind, whatever the values.
TriangleMesh read_unchecked_mesh(const PointsIn& V, const TrianglesIn& F);
Edges read_edges(const EdgesIn& edges, Eigen::Index vertex_count, const char* name);
// M x a x b as M x 6, a b = 6.
Array6 read_blocks(const BlocksIn& blocks, const char* name, int a, int b);
// Lists of tiles, and of pairs of them.
void require_tiles(const std::vector<int>& tiles, Eigen::Index tile_count, const char* name);
void require_tiles(const std::vector<std::array<int, 2>>& pairs, Eigen::Index tile_count,
                   const char* name);
// A finite number greater than 0.
void require_positive(double value, const char* name);

}  // namespace curveups::bindings

namespace pybind11::detail {

// The names are those of the arrays' own types, for signatures and stubs.
#define CURVEUPS_ARRAY_CASTER(type, text)               \
  template <>                                           \
  struct type_caster<type> {                            \
    PYBIND11_TYPE_CASTER(type, const_name(text));       \
    bool load(handle source, bool) {                    \
      value.given = reinterpret_borrow<object>(source); \
      return true;                                      \
    }                                                   \
  }
CURVEUPS_ARRAY_CASTER(curveups::bindings::PointsIn, "numpy.ndarray[numpy.float64[m, 3]]");
CURVEUPS_ARRAY_CASTER(curveups::bindings::TrianglesIn, "numpy.ndarray[numpy.int32[m, 3]]");
CURVEUPS_ARRAY_CASTER(curveups::bindings::EdgesIn, "numpy.ndarray[numpy.int32[m, 2]]");
CURVEUPS_ARRAY_CASTER(curveups::bindings::BlocksIn, "numpy.ndarray[numpy.float64]");
#undef CURVEUPS_ARRAY_CASTER

}  // namespace pybind11::detail
