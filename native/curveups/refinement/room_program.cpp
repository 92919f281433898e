// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/room_program.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "curveups/core/parallel.hpp"
#include "curveups/design/pin_bounds.hpp"
#include "curveups/design/vertex_patch.hpp"
#include "curveups/numerics/least_step.hpp"

namespace curveups {
namespace {

// Sides are lifted to a little more than A_pin_min, room for the layout; those with less than
// near_minimum times A_pin_min must not lose what they need.
constexpr double goal = 1.03, kept = 1.002, near_minimum = 1.5;

// Folds sharper than this must not become sharper: they already bound insets on either side.
constexpr double sharp = 0.3;  // rad

// By how much the linear scale of the largest pin exceeds that of `share` times A_pin_min, in mm.
double excess(const TileMesh& tiles, const Truncation& truncation, const Parameters& p, int tile,
              Side side, double share) {
  const double scale = pin_room(tiles, truncation, p, tile, side, p.p_min).scale;
  return p.L * (scale - std::sqrt(share * p.A_pin_min / tiles.area(tile)));
}

}  // namespace

// One requirement: room for a pin, or a fold that is not to become sharper.
struct RoomProgram::Need {
  int tile, edge;  // edge -1: of a pin
  Side side;
  double share;  // of A_pin_min
  bool operator<(const Need& o) const {
    return std::tie(tile, edge, side) < std::tie(o.tile, o.edge, o.side);
  }
};

RoomProgram::RoomProgram(const TriangleMesh& target, const Edges& cuts,
                         const Parameters& parameters)
    : target_(target), cuts_(cuts), parameters_(parameters) {
  fold_ = make_tile_mesh(target, cuts, parameters.H_body).fold;
  weight_ = Eigen::VectorXd::Zero(target.V.rows());
  for (int i = 0; i < target.F.rows(); ++i) {
    const double third = face_area_vector(target, i).norm() / 3;
    for (int t = 0; t < 3; ++t) weight_(target.F(i, t)) += third;
  }
}

DesignGeometry RoomProgram::geometry(const TriangleMesh& mesh) const {
  DesignGeometry here;
  here.tiles = make_tile_mesh(mesh, cuts_, parameters_.H_body);
  here.shaped = tiles_without_back(here.tiles).empty();
  if (here.shaped) return make_geometry(mesh, cuts_, parameters_);
  here.truncation.of_tile.resize(here.tiles.tile_count());
  here.truncation.front_pins.resize(here.tiles.tile_count());
  here.pin_bounds = compute_pin_bounds(here.tiles, here.truncation, parameters_);
  return here;
}

double RoomProgram::missing(const DesignGeometry& here) const {
  double sum = 0;
  for (const SmallPin& pin : here.pin_bounds.small) {
    const double lack = -excess(here.tiles, here.truncation, parameters_, pin.tile, pin.side, 1);
    sum += std::isfinite(lack) ? std::max(0.0, lack) : 100 * parameters_.L;
  }
  return sum;
}

// tile: as `tiles` numbers it.
double RoomProgram::value(const Need& need, const TileMesh& tiles, const Truncation& truncation,
                          int tile) const {
  if (need.edge < 0) return excess(tiles, truncation, parameters_, tile, need.side, need.share);
  const double before = fold_(need.tile, need.edge), now = tiles.fold(tile, need.edge);
  return 0.5 * parameters_.L * (before > 0 ? before - now : now - before);
}

std::vector<RoomProgram::Row> RoomProgram::rows(const DesignGeometry& here, const PinSides& small,
                                                const PinSides& asked,
                                                const std::vector<int>& vertices) const {
  struct Entry {
    Need need;
    Vec3 derivative;
  };
  const VertexPatches patches(here);
  std::vector<std::vector<Entry>> entries(vertices.size());
  parallel_ranges(static_cast<int>(vertices.size()), [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      const VertexPatch patch = patches.around(vertices[v]);
      std::vector<std::pair<Need, int>> local;  // with the tile in the patch
      for (int k : patch.near) {
        const int tile = patch.tiles[k];
        for (Side side : {Side::front, Side::back}) {
          const PinRoom room =
              pin_room(here.tiles, here.truncation, parameters_, tile, side, parameters_.p_min);
          const bool close = room.area < near_minimum * parameters_.A_pin_min;
          if (!std::isfinite(room.scale) || !(close || asked.count({tile, side}))) continue;
          local.push_back({{tile, -1, side, asked.count({tile, side}) ? goal : kept}, k});
        }
        for (int t = 0; t < 3; ++t) {
          if (here.tiles.topology.neighbour(tile, t) < tile) continue;  // each edge once
          if (std::abs(fold_(tile, t)) > sharp) local.push_back({{tile, t, Side::front, 0}, k});
        }
      }
      if (local.empty()) continue;
      const Eigen::MatrixXd by_vertex = derivatives_by_vertex(patch, [&](const LocalGeometry& g) {
        Eigen::VectorXd out(static_cast<Eigen::Index>(local.size()));
        for (std::size_t r = 0; r < local.size(); ++r) {
          out(static_cast<Eigen::Index>(r)) =
              value(local[r].first, g.tiles, g.truncation, local[r].second);
        }
        return out;
      });
      for (std::size_t r = 0; r < local.size(); ++r) {
        const Vec3 derivative = by_vertex.row(static_cast<Eigen::Index>(r));
        if (derivative.allFinite() && derivative.norm() > 1e-9) {
          entries[v].push_back({local[r].first, derivative});
        }
      }
    }
  });
  std::map<Need, Row> found;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (const Entry& entry : entries[v]) {
      found[entry.need].by_vertex.push_back({static_cast<int>(v), entry.derivative});
    }
  }
  std::vector<Row> out;
  for (auto& [need, row] : found) {
    row.value = value(need, here.tiles, here.truncation, need.tile);
    // Sides out of reach must not lose what they have.
    if (need.edge < 0 && !asked.count({need.tile, need.side}) &&
        small.count({need.tile, need.side})) {
      row.value = std::max(0.0, row.value);
    }
    out.push_back(std::move(row));
  }
  return out;
}

bool RoomProgram::step(const std::vector<Row>& rows, const std::vector<int>& vertices,
                       const MoveLimits& limits, TriangleMesh& mesh) const {
  const Eigen::Index count = 3 * static_cast<Eigen::Index>(vertices.size());
  const double trust = limits.step, limit = limits.whole;
  LeastStepProblem problem;
  problem.lower.resize(count);
  problem.upper.resize(count);
  problem.wanted.resize(count);
  Eigen::VectorXd scale(count);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const int v = vertices[k];
    for (int c = 0; c < 3; ++c) {
      const Eigen::Index at = 3 * static_cast<Eigen::Index>(k) + c;
      scale(at) = std::sqrt(weight_(v)) / parameters_.L;
      const double moved = mesh.V(v, c) - target_.V(v, c);
      problem.wanted(at) = -scale(at) * moved;
      problem.lower(at) = scale(at) * std::min(0.0, std::max(-trust, -limit - moved));
      problem.upper(at) = scale(at) * std::max(0.0, std::min(trust, limit - moved));
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  problem.sparse_value.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    problem.sparse_value(static_cast<Eigen::Index>(r)) = rows[r].value;
    for (const auto& [k, derivative] : rows[r].by_vertex) {
      for (int c = 0; c < 3; ++c) {
        entries.emplace_back(static_cast<int>(r), 3 * k + c, derivative(c) / scale(3 * k + c));
      }
    }
  }
  problem.sparse.resize(static_cast<Eigen::Index>(rows.size()), count);
  problem.sparse.setFromTriplets(entries.begin(), entries.end());
  problem.dense.resize(count, 0);
  problem.dense_value.resize(0);
  const Eigen::VectorXd z = solve_least_step(problem).z;
  double largest = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    for (int c = 0; c < 3; ++c) {
      const Eigen::Index at = 3 * static_cast<Eigen::Index>(k) + c;
      mesh.V(vertices[k], c) += z(at) / scale(at);
      largest = std::max(largest, std::abs(z(at) / scale(at)));
    }
  }
  return largest > 1e-5 * parameters_.L;
}

std::vector<int> vertices_around(const PinSides& sides, const TriangleMesh& mesh) {
  std::vector<char> marked(mesh.V.rows(), 0), moves(mesh.V.rows(), 0);
  for (const PinSide& side : sides) {
    for (int t = 0; t < 3; ++t) marked[mesh.F(side.first, t)] = 1;
  }
  for (int i = 0; i < mesh.F.rows(); ++i) {
    if (!marked[mesh.F(i, 0)] && !marked[mesh.F(i, 1)] && !marked[mesh.F(i, 2)]) continue;
    for (int t = 0; t < 3; ++t) moves[mesh.F(i, t)] = 1;
  }
  std::vector<int> vertices;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    if (moves[v]) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace curveups
