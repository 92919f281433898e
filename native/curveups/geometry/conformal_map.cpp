// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/conformal_map.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {
namespace {

// Vectors of the iteration: four complex modes. The lowest converges with the ratio of the first to
// the fifth eigenvalue; the first two are close together for a long strip.
constexpr int block = 8;
constexpr int most_iterations = 200;

// Throws unless the piece can be flattened without cuts.
void check_topology(const MeshTopology& topology) {
  const std::vector<int> component = face_components(topology, {});
  if (*std::max_element(component.begin(), component.end()) > 0) {
    throw TopologyError("the surface has several components", "flatten each by itself");
  }
  const int loops = static_cast<int>(boundary_loops(topology).size());
  if (loops == 0) {
    throw TopologyError("the surface is closed and has no flat layout",
                        "cut it open (--auto-cuts 1 or pieces=auto does)");
  }
  const int handles = handle_count(topology, loops);
  if (handles > 0) {
    throw TopologyError("the surface has " + std::to_string(handles) +
                            (handles == 1 ? " handle" : " handles") + " and no flat layout",
                        "cut each handle open (--auto-cuts 1 or pieces=auto does)");
  }
}

// Weight of each vertex in the norm of the constraint: half of its boundary edges over the
// boundary's length.
Eigen::VectorXd boundary_weights(const TriangleMesh& mesh, const MeshTopology& topology) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(mesh.V.rows());
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.boundary()) continue;
    const double length = (mesh.V.row(edge.v[1]) - mesh.V.row(edge.v[0])).norm();
    weight[edge.v[0]] += length;
    weight[edge.v[1]] += length;
  }
  return weight / weight.sum();
}

// Lower triangle of the conformal energy's matrix, Dirichlet energy minus area, plus shift times
// the boundary norm. x of vertex v is unknown 2 v, y is 2 v + 1. Unused vertices get a one on the
// diagonal.
SparseMatrix conformal_energy(const TriangleMesh& mesh, const MeshTopology& topology,
                              const Eigen::VectorXd& weight, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.F.rows() * 18 + mesh.V.rows() * 2);
  auto add = [&](int i, int j, double value) {
    entries.emplace_back(std::max(i, j), std::min(i, j), value);
  };
  std::vector<char> used(mesh.V.rows(), 0);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const double area = face_area_vector(mesh, f).norm();
    for (int t = 0; t < 3; ++t) {
      const int a = mesh.F(f, t), b = mesh.F(f, next3(t)), c = mesh.F(f, prev3(t));
      used[a] = 1;
      const Vec3 ca = mesh.V.row(a) - mesh.V.row(c), cb = mesh.V.row(b) - mesh.V.row(c);
      const double quarter_cot = ca.dot(cb) / (8 * area);
      for (int k = 0; k < 2; ++k) {
        add(2 * a + k, 2 * a + k, quarter_cot);
        add(2 * b + k, 2 * b + k, quarter_cot);
        add(2 * a + k, 2 * b + k, -quarter_cot);
      }
    }
  }
  // The area of the map is a sum over its boundary: (x_a y_b - x_b y_a) / 2 for each edge.
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.boundary()) continue;
    const int a = edge.v[0], b = edge.v[1];
    add(2 * a, 2 * b + 1, -0.25);
    add(2 * b, 2 * a + 1, 0.25);
  }
  for (int v = 0; v < mesh.V.rows(); ++v) {
    const double diagonal = used[v] ? shift * weight[v] : 1.0;
    for (int k = 0; k < 2; ++k) entries.emplace_back(2 * v + k, 2 * v + k, diagonal);
  }
  SparseMatrix matrix(2 * mesh.V.rows(), 2 * mesh.V.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Takes one step of subspace iteration with K^-1 B: the columns of x become Ritz vectors of unit
// boundary norm, the least energy first, the boundary's centroid at the origin.
void improve(const SparseCholesky& solver, const Eigen::VectorXd& weight,
             const Eigen::VectorXd& norm, Eigen::MatrixXd& x) {
  const Eigen::MatrixXd weighted = norm.asDiagonal() * x;
  x = solver.solve(weighted);
  for (auto column : x.colwise()) {
    Eigen::Map<Points2> points(column.data(), weight.size(), 2);
    const Eigen::RowVector2d centroid = weight.transpose() * points;
    points.rowwise() -= centroid;
  }
  const Eigen::MatrixXd projected = weighted.transpose() * x;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(projected + projected.transpose());
  x = (x * ritz.eigenvectors().rowwise().reverse()).eval();
  const Eigen::MatrixXd factors =
      Eigen::MatrixXd(norm.cwiseSqrt().asDiagonal() * x).householderQr().matrixQR();
  factors.topRows(x.cols()).triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(x);
}

// Generalised eigenvector of the least eigenvalue. The shift is a multiple of the norm and changes
// no eigenvector; it makes the matrix definite, as translations (and all similarities of a flat
// surface) have no energy.
Eigen::VectorXd least_mode(const TriangleMesh& mesh, const MeshTopology& topology) {
  const double shift = 1e-7;
  const Eigen::VectorXd weight = boundary_weights(mesh, topology);
  SparseCholesky solver;
  if (!solver.factorize(conformal_energy(mesh, topology, weight, shift))) {
    throw SolverFailure("the conformal map's system is not positive definite",
                        "remesh the surface: it has faces with next to no area");
  }
  const Eigen::VectorXd norm = weight.replicate(1, 2).reshaped<Eigen::RowMajor>();
  // A deterministic ripple, to which no mode is orthogonal.
  const Eigen::Index modes = std::min<Eigen::Index>(block, 2 * (weight.array() > 0).count() - 2);
  Eigen::MatrixXd x = Eigen::MatrixXd::NullaryExpr(
      norm.size(), modes, [](auto i, auto c) { return std::sin(1.0 + 0.7391 * i * (c + 1)); });
  Eigen::VectorXd least = x.col(0), turned(x.rows());
  double last_change = 1;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    checkpoint();
    improve(solver, weight, norm, x);
    if (!x.allFinite()) {
      throw SolverFailure("the conformal map could not be computed", "remesh the surface");
    }
    // Rotations of the mode span a plane: the change is the old vector's part outside of it.
    for (int v = 0; v < weight.size(); ++v) {
      turned[2 * v] = -x(2 * v + 1, 0);
      turned[2 * v + 1] = x(2 * v, 0);
    }
    const Eigen::VectorXd weighted = norm.asDiagonal() * least;
    const Eigen::VectorXd rest =
        least - x.col(0) * x.col(0).dot(weighted) - turned * turned.dot(weighted);
    const double change = std::sqrt(std::max(0.0, rest.dot(norm.asDiagonal() * rest)));
    least = x.col(0);
    // Below 1e-7 a change that no longer shrinks is rounding.
    if (change < 1e-11 || (change < 1e-7 && change > 0.9 * last_change)) break;
    last_change = change;
  }
  return least;
}

double signed_area(const Triangles& F, const Points2& map, int f) {
  const Vec2 a = map.row(F(f, 0)), b = map.row(F(f, 1)), c = map.row(F(f, 2));
  return 0.5 * wedge(b - a, c - a);
}

// Closes every boundary loop but the longest by a fan around its centroid, after the mesh's own
// faces and vertices. On a ring z and 1 / z have the same energy by symmetry, and their sum folds
// over; without holes only maps without poles remain.
TriangleMesh with_holes_closed(const TriangleMesh& mesh, const MeshTopology& topology) {
  const std::vector<std::vector<int>> loops = boundary_loops(topology);
  std::size_t outer = 0;
  double longest = -1;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const double length = loop_length(mesh.V, loops[l]);
    if (length > longest * (1 + 1e-9)) {
      longest = length;
      outer = l;
    }
  }
  TriangleMesh closed = mesh;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (l == outer) continue;
    const int count = static_cast<int>(loops[l].size());
    const int centre = static_cast<int>(closed.V.rows()), first = static_cast<int>(closed.F.rows());
    closed.V.conservativeResize(centre + 1, 3);
    closed.F.conservativeResize(first + count, 3);
    Vec3 mean = Vec3::Zero();
    for (int v : loops[l]) mean += mesh.V.row(v).transpose() / count;
    closed.V.row(centre) = mean;
    for (int i = 0; i < count; ++i) {
      closed.F.row(first + i) << loops[l][(i + 1) % count], loops[l][i], centre;
    }
  }
  return closed;
}

}  // namespace

Points2 conformal_map(const TriangleMesh& mesh) {
  const MeshTopology topology = build_topology(mesh.F);
  check_topology(topology);
  const TriangleMesh disc = with_holes_closed(mesh, topology);
  const Eigen::VectorXd mode = least_mode(disc, build_topology(disc.F));
  Points2 map = Eigen::Map<const Points2>(mode.data(), mesh.V.rows(), 2);

  double area = 0;
  Vec2 moment = Vec2::Zero();
  std::vector<char> used(mesh.V.rows(), 0);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const double a = signed_area(mesh.F, map, f);
    area += a;
    for (int t = 0; t < 3; ++t) {
      used[mesh.F(f, t)] = 1;
      moment += a / 3 * map.row(mesh.F(f, t)).transpose();
    }
  }
  if (!(area > 0)) {
    throw SolverFailure("the conformal map turned the surface over", "remesh the surface");
  }
  // Rotate the first face's first edge to x.
  const Vec2 edge = (map.row(mesh.F(0, 1)) - map.row(mesh.F(0, 0))).normalized();
  Eigen::Matrix2d turn;  // rotation of rows
  turn << edge.x(), -edge.y(), edge.y(), edge.x();
  const double scale = std::sqrt(surface_area(mesh) / area);
  for (int v = 0; v < map.rows(); ++v) {
    if (used[v]) {
      map.row(v) = ((map.row(v) - moment.transpose() / area) * turn * scale).eval();
    } else {
      map.row(v).setZero();
    }
  }
  return map;
}

Eigen::VectorXd conformal_scale(const TriangleMesh& mesh, const Points2& map) {
  Eigen::VectorXd scale(mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const double ratio = signed_area(mesh.F, map, f) / face_area_vector(mesh, f).norm();
    scale[f] = std::copysign(std::sqrt(std::abs(ratio)), ratio);
  }
  return scale;
}

}  // namespace curveups
