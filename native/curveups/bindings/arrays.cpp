// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"

namespace curveups::bindings {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& why,
                         const std::string& remedy) {
  throw InvalidInput(name + " " + why, remedy);
}

// The object as an array of one of the kinds ('f' for floats, 'i' and 'u' for integers).
py::array as_array(const py::object& given, const char* name, const char* kinds, const char* what) {
  py::array array = py::array::ensure(given);
  if (!array) refuse(name, "is no array", std::string("pass ") + what);
  // An empty list has no kind of its own.
  if (array.size() > 0 && std::string(kinds).find(array.dtype().kind()) == std::string::npos) {
    refuse(name, "does not consist of such numbers", std::string("pass ") + what);
  }
  return array;
}

[[noreturn]] void refuse_shape(const char* name, const std::string& shape) {
  refuse(name, "does not have the shape " + shape, "pass one row for each");
}

// Rows of an n x columns array; an empty list stands for none.
Eigen::Index rows_of(const py::array& array, const char* name, int columns) {
  if (array.ndim() == 1 && array.size() == 0) return 0;
  if (array.ndim() != 2 || array.shape(1) != columns) {
    refuse_shape(name, "n x " + std::to_string(columns));
  }
  return array.shape(0);
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

Points3 any_points(const PointsIn& points, const char* name) {
  const Doubles array = as_array(points.given, name, "fiu", "an N x 3 array of numbers");
  return Eigen::Map<const Points3>(array.data(), rows_of(array, name, 3), 3);
}

template <class Matrix>
Matrix any_indices(const py::object& given, const char* name) {
  constexpr int columns = Matrix::ColsAtCompileTime;
  const Integers array = as_array(given, name, "iu", "an array of integers");
  const Eigen::Index rows = rows_of(array, name, columns);
  for (Eigen::Index k = 0; k < rows * columns; ++k) {
    const std::int64_t index = array.data()[k];
    if (index < std::numeric_limits<int>::min() || index > std::numeric_limits<int>::max()) {
      refuse(std::string(name) + "[" + std::to_string(k / columns) + "]",
             "holds an index out of range", "name what there is, from 0");
    }
  }
  using Wide = Eigen::Matrix<std::int64_t, Eigen::Dynamic, columns, Eigen::RowMajor>;
  return Eigen::Map<const Wide>(array.data(), rows, columns).template cast<int>();
}

template <class Matrix>
void require_within(const Matrix& indices, Eigen::Index count, const char* name) {
  for (Eigen::Index i = 0; i < indices.rows(); ++i) {
    const int low = indices.row(i).minCoeff(), high = indices.row(i).maxCoeff();
    if (low >= 0 && high < count) continue;
    refuse(std::string(name) + "[" + std::to_string(i) + "]",
           "names vertex " + std::to_string(low < 0 ? low : high) + ", there are " +
               std::to_string(count),
           "number them from 0");
  }
}

void require_tile(int tile, Eigen::Index tile_count, const char* name) {
  if (tile >= 0 && tile < tile_count) return;
  refuse(name, "names tile " + std::to_string(tile) + ", there are " + std::to_string(tile_count),
         "number them from 0");
}

}  // namespace

Points3 read_points(const PointsIn& points, const char* name) {
  Points3 out = any_points(points, name);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const double largest = out.row(i).cwiseAbs().maxCoeff();
    if (out.row(i).allFinite() && largest <= tolerance::largest_coordinate) continue;
    refuse(std::string(name) + "[" + std::to_string(i) + "]",
           out.row(i).allFinite() ? "lies too far out" : "is not finite",
           "give finite coordinates in mm");
  }
  return out;
}

TriangleMesh read_unchecked_mesh(const PointsIn& V, const TrianglesIn& F) {
  return {any_points(V, "V"), any_indices<Triangles>(F.given, "F")};
}

TriangleMesh read_mesh(const PointsIn& V, const TrianglesIn& F, const char* V_name,
                       const char* F_name) {
  TriangleMesh mesh{read_points(V, V_name), any_indices<Triangles>(F.given, F_name)};
  if (mesh.F.rows() == 0) refuse(F_name, "has no faces", "pass one or more");
  require_within(mesh.F, mesh.V.rows(), F_name);
  return mesh;
}

Edges read_edges(const EdgesIn& edges, Eigen::Index vertex_count, const char* name) {
  Edges out = any_indices<Edges>(edges.given, name);
  require_within(out, vertex_count, name);
  return out;
}

Array6 read_blocks(const BlocksIn& blocks, const char* name, int a, int b) {
  const Doubles array = as_array(blocks.given, name, "fiu", "numbers, one block per tile");
  if (array.ndim() != 3 || array.shape(1) != a || array.shape(2) != b) {
    refuse_shape(name, "M x " + std::to_string(a) + " x " + std::to_string(b));
  }
  Array6 out = Eigen::Map<const Array6>(array.data(), array.shape(0), 6);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    if (out.row(i).allFinite()) continue;
    refuse(std::string(name) + "[" + std::to_string(i) + "]", "is not finite",
           "give lengths in mm");
  }
  return out;
}

void require_tiles(const std::vector<int>& tiles, Eigen::Index tile_count, const char* name) {
  for (const int tile : tiles) require_tile(tile, tile_count, name);
}

void require_tiles(const std::vector<std::array<int, 2>>& pairs, Eigen::Index tile_count,
                   const char* name) {
  for (const std::array<int, 2>& pair : pairs) {
    for (const int tile : pair) require_tile(tile, tile_count, name);
  }
}

void require_positive(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) {
    refuse(name, "is not a positive number", "give one in mm");
  }
}

}  // namespace curveups::bindings
