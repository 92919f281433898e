// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"

#include <cmath>
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

std::string row_name(const char* name, Eigen::Index row) {
  return std::string(name) + "[" + std::to_string(row) + "]";
}

// Rows of an n x columns array.
Eigen::Index rows_of(const py::array& array, const char* name, int columns) {
  if (array.ndim() != 2 || array.shape(1) != columns) {
    refuse(name, "does not have the shape n x " + std::to_string(columns), "pass one row for each");
  }
  return array.shape(0);
}

Points3 to_points(const NumbersIn& points, const char* name) {
  return Eigen::Map<const Points3>(points.data(), rows_of(points, name, 3), 3);
}

template <class Matrix>
Matrix to_indices(const IndicesIn& indices, const char* name) {
  constexpr int columns = Matrix::ColsAtCompileTime;
  using Wide = Eigen::Matrix<std::int64_t, Eigen::Dynamic, columns, Eigen::RowMajor>;
  const Eigen::Map<const Wide> wide(indices.data(), rows_of(indices, name, columns), columns);
  for (Eigen::Index i = 0; i < wide.rows(); ++i) {
    if (wide.row(i).minCoeff() < std::numeric_limits<int>::min() ||
        wide.row(i).maxCoeff() > std::numeric_limits<int>::max()) {
      refuse(row_name(name, i), "holds an index out of range", "name what there is, from 0");
    }
  }
  return wide.template cast<int>();
}

template <class Matrix>
void require_within(const Matrix& indices, Eigen::Index count, const char* name) {
  for (Eigen::Index i = 0; i < indices.rows(); ++i) {
    const int low = indices.row(i).minCoeff(), high = indices.row(i).maxCoeff();
    if (low >= 0 && high < count) continue;
    refuse(row_name(name, i),
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

Points3 read_points(const NumbersIn& points, const char* name) {
  Points3 out = to_points(points, name);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const bool finite = out.row(i).allFinite();
    if (finite && out.row(i).cwiseAbs().maxCoeff() <= tolerance::largest_coordinate) continue;
    refuse(row_name(name, i), finite ? "lies too far out" : "is not finite",
           "give finite coordinates in mm");
  }
  return out;
}

TriangleMesh read_unchecked_mesh(const NumbersIn& V, const IndicesIn& F) {
  return {to_points(V, "V"), to_indices<Triangles>(F, "F")};
}

TriangleMesh read_mesh(const NumbersIn& V, const IndicesIn& F, const char* V_name,
                       const char* F_name) {
  TriangleMesh mesh{read_points(V, V_name), to_indices<Triangles>(F, F_name)};
  if (mesh.F.rows() == 0) refuse(F_name, "has no faces", "pass one or more");
  require_within(mesh.F, mesh.V.rows(), F_name);
  return mesh;
}

Edges read_edges(const IndicesIn& edges, Eigen::Index vertex_count, const char* name) {
  Edges out = to_indices<Edges>(edges, name);
  require_within(out, vertex_count, name);
  return out;
}

CutMesh read_cut_mesh(const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts) {
  TriangleMesh mesh = read_mesh(V, F);
  Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
  return {std::move(mesh), std::move(edges)};
}

Array6 read_blocks(const NumbersIn& blocks, const char* name, int a, int b) {
  if (blocks.ndim() != 3 || blocks.shape(1) != a || blocks.shape(2) != b) {
    refuse(name, "does not have the shape M x " + std::to_string(a) + " x " + std::to_string(b),
           "pass one block for each tile");
  }
  Array6 out = Eigen::Map<const Array6>(blocks.data(), blocks.shape(0), 6);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    if (!out.row(i).allFinite()) refuse(row_name(name, i), "is not finite", "give lengths in mm");
  }
  return out;
}

void require_tiles(const std::vector<int>& tiles, Eigen::Index tile_count, const char* name) {
  for (const int tile : tiles) require_tile(tile, tile_count, name);
}

void require_tiles(const std::vector<std::array<int, 2>>& pairs, Eigen::Index tile_count,
                   const char* name) {
  for (const auto& [a, b] : pairs) require_tiles({a, b}, tile_count, name);
}

void require_positive(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) {
    refuse(name, "is not a positive number", "give one in mm");
  }
}

}  // namespace curveups::bindings
