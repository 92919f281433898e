// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/clearance_program.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "curveups/core/parallel.hpp"
#include "curveups/design/membrane_clearance.hpp"
#include "curveups/design/pin_bounds.hpp"
#include "curveups/design/vertex_patch.hpp"
#include "curveups/numerics/least_step.hpp"

namespace curveups {
namespace {

// Areas over A_pin_min: to which sides are lifted, a little more for the layout; which others keep;
// and below which others are looked at.
constexpr double goal = 1.03, kept = 1.002, near_minimum = 1.5;

// The same for room under membranes, as parts of H_pin.
constexpr double gap_goal = least_membrane_clearance + 0.1,
                 gap_kept = least_membrane_clearance + 0.002,
                 near_gap = 2 * least_membrane_clearance;

// Folds sharper than this must not become sharper: they already bound insets on either side.
constexpr double sharp = 0.3;  // rad

}  // namespace

PinSides sides_of(const std::vector<SmallPin>& pins) {
  PinSides sides;
  for (const SmallPin& pin : pins) sides.insert({pin.tile, pin.side});
  return sides;
}

// Largest pins of one geometry and the tiles at its vertices, each computed once.
class ClearanceProgram::Pins {
 public:
  Pins(const TileMesh& of, const Truncation& truncation, const Parameters& parameters)
      : tiles(of),
        truncation_(truncation),
        parameters_(parameters),
        regions_(2 * static_cast<std::size_t>(of.tile_count())),
        lower_(Array6::Zero(of.tile_count(), 6)) {}

  const PinRegion& region(int tile, Side side) {
    std::optional<PinRegion>& known = regions_[2 * tile + (side == Side::back ? 1 : 0)];
    if (!known) {
      known = pin_region(tiles, truncation_, parameters_, tile, side, parameters_.p_min);
      for (int t = 0; t < 3; ++t) lower_(tile, inset_index(side, t)) = known->lower[t];
    }
    return *known;
  }

  // Excess of the linear scale of the largest pin over that of `share` times A_pin_min, mm.
  double excess(int tile, Side side, double share) {
    const double least = std::sqrt(share * parameters_.A_pin_min / tiles.area(tile));
    return parameters_.L * (region(tile, side).scale - least);
  }

  // Clearance of a side's membrane over the corners at a vertex, mm.
  double over_corners(int vertex, const std::vector<int>& around, Side side) {
    for (int tile : around) region(tile, side);
    const std::vector<double> clearances =
        corner_clearances(tiles, lower_, parameters_.H_pin, side, vertex, around);
    return *std::min_element(clearances.begin(), clearances.end());
  }

  double over_edge(int tile, int edge, Side side) {
    return edge_clearance(tiles.dihedral(tile, edge), side, region(tile, side).lower[edge],
                          parameters_.H_pin);
  }

  const std::vector<int>& at_vertex(int vertex) {
    if (at_vertex_.empty()) at_vertex_ = tiles_at_vertices(tiles);
    return at_vertex_[vertex];
  }

  const TileMesh& tiles;

 private:
  const Truncation& truncation_;
  const Parameters& parameters_;
  std::vector<std::optional<PinRegion>> regions_;
  Array6 lower_;
  std::vector<std::vector<int>> at_vertex_;
};

// Requirement: room for a pin, a fold that is not to become sharper, or room under a membrane
// over the corners at a vertex or over the edge of a tile.
struct ClearanceProgram::Need {
  enum Kind { tile_shape, corner_gap, edge_gap };
  Kind kind;
  int at, edge;  // a tile and its edge, -1: of a pin; or a vertex
  Side side;
  double share;  // share of A_pin_min or H_pin
  bool operator<(const Need& o) const {
    return std::tie(kind, at, edge, side) < std::tie(o.kind, o.at, o.edge, o.side);
  }
};

// Room under a membrane; the share of its need is set later.
struct ClearanceProgram::Gap {
  Need need;
  double clearance;  // mm
  std::vector<int> tiles;
};

ClearanceProgram::ClearanceProgram(const TriangleMesh& target, const Edges& cuts,
                                   const Parameters& parameters, bool membranes)
    : target_(target), cuts_(cuts), parameters_(parameters), membranes_(membranes) {
  dihedral_ = make_tile_mesh(target, cuts, parameters.H_body).dihedral;
  weight_ = Eigen::VectorXd::Zero(target.V.rows());
  for (int i = 0; i < target.F.rows(); ++i) {
    const double third = face_area_vector(target, i).norm() / 3;
    for (int t = 0; t < 3; ++t) weight_(target.F(i, t)) += third;
  }
}

DesignGeometry ClearanceProgram::geometry(const TriangleMesh& mesh) const {
  DesignGeometry here;
  here.tiles = make_tile_mesh(mesh, cuts_, parameters_.H_body);
  here.shaped = tiles_without_back(here.tiles).empty();
  if (here.shaped) return make_geometry(std::move(here.tiles), parameters_);
  here.truncation.of_tile.resize(here.tiles.tile_count());
  here.truncation.front_pins.resize(here.tiles.tile_count());
  here.pin_bounds = compute_pin_bounds(here.tiles, here.truncation, parameters_);
  return here;
}

double ClearanceProgram::missing(const DesignGeometry& here) const {
  Pins pins(here.tiles, here.truncation, parameters_);
  double sum = 0;
  for (const SmallPin& pin : here.pin_bounds.small) {
    const double lack = -pins.excess(pin.tile, pin.side, 1);
    sum += std::isfinite(lack) ? std::max(0.0, lack) : 100 * parameters_.L;
  }
  for (const Gap& gap : gaps(here, least_membrane_clearance, pins)) {
    sum += least_membrane_clearance * parameters_.H_pin - gap.clearance;
  }
  return sum;
}

std::vector<SmallPin> ClearanceProgram::lacking(const DesignGeometry& here) const {
  std::vector<SmallPin> out = here.pin_bounds.small;
  PinSides known = sides_of(out);
  Pins pins(here.tiles, here.truncation, parameters_);
  for (const Gap& gap : gaps(here, least_membrane_clearance, pins)) {
    const Side side = gap.need.side;
    for (int tile : gap.tiles) {
      if (known.insert({tile, side}).second) {
        out.push_back({tile, side, pins.region(tile, side).area});
      }
    }
  }
  return out;
}

std::vector<ClearanceProgram::Gap> ClearanceProgram::gaps(const DesignGeometry& here, double most,
                                                          Pins& pins) const {
  std::vector<Gap> out;
  if (!membranes_ || !here.shaped) return out;
  const double limit = most * parameters_.H_pin;
  const std::vector<std::vector<int>> around = tiles_around_inner_vertices(here.tiles);
  for (Side side : {Side::front, Side::back}) {
    for (int v = 0; v < static_cast<int>(around.size()); ++v) {
      if (around[v].empty()) continue;
      const double clearance = pins.over_corners(v, around[v], side);
      if (clearance < limit)
        out.push_back({{Need::corner_gap, v, -1, side, 0}, clearance, around[v]});
    }
    for (const Contact& contact : here.tiles.contacts) {
      for (int s = 0; s < 2; ++s) {
        const int tile = contact.tile[s], edge = contact.side[s];
        const double clearance = pins.over_edge(tile, edge, side);
        if (clearance < limit)
          out.push_back({{Need::edge_gap, tile, edge, side, 0}, clearance, {tile}});
      }
    }
  }
  return out;
}

// at: number of the tile or vertex in the tiles of `pins`.
double ClearanceProgram::value(const Need& need, Pins& pins, int at) const {
  const double wanted = need.share * parameters_.H_pin;
  if (need.kind == Need::edge_gap) return pins.over_edge(at, need.edge, need.side) - wanted;
  if (need.kind == Need::corner_gap) {
    return pins.over_corners(at, pins.at_vertex(at), need.side) - wanted;
  }
  if (need.edge < 0) return pins.excess(at, need.side, need.share);
  const double before = dihedral_(need.at, need.edge), now = pins.tiles.dihedral(at, need.edge);
  return 0.5 * parameters_.L * (before > 0 ? before - now : now - before);
}

std::vector<ClearanceProgram::Row> ClearanceProgram::rows(const DesignGeometry& here,
                                                          const PinSides& small,
                                                          const PinSides& lifted,
                                                          const std::vector<int>& vertices) const {
  struct Entry {
    Need need;
    Vec3 derivative;
  };
  std::map<std::tuple<Need::Kind, int, int>, std::vector<Need>> narrow;  // kind, place, edge
  Pins pins(here.tiles, here.truncation, parameters_);
  for (int i = 0; i < here.tiles.tile_count(); ++i) {
    for (Side side : {Side::front, Side::back}) pins.region(i, side);  // for all threads
  }
  for (Gap& gap : gaps(here, near_gap, pins)) {
    const bool lift = std::any_of(gap.tiles.begin(), gap.tiles.end(), [&](int tile) {
      return lifted.count({tile, gap.need.side}) != 0;
    });
    gap.need.share = lift ? gap_goal : gap_kept;
    narrow[{gap.need.kind, gap.need.at, gap.need.edge}].push_back(gap.need);
  }
  const VertexPatches patches(here);
  std::vector<std::vector<Entry>> entries(vertices.size());
  parallel_ranges(static_cast<int>(vertices.size()), [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      const VertexPatch patch = patches.around(vertices[v]);
      std::vector<std::pair<Need, int>> local;  // with the number of tile or vertex in the patch
      const auto add_gaps = [&](Need::Kind kind, int at, int edge, int in_patch) {
        const auto it = narrow.find({kind, at, edge});
        if (it == narrow.end()) return;
        for (const Need& need : it->second) local.push_back({need, in_patch});
      };
      if (!narrow.empty()) {
        std::map<int, int> touched;  // vertices in the patch, with their numbers in the design
        for (std::size_t k = 0; k < patch.tiles.size(); ++k) {
          for (int t = 0; t < 3; ++t) {
            const int w = patch.mesh.F(static_cast<Eigen::Index>(k), t);
            if (std::binary_search(patch.touched.begin(), patch.touched.end(), w)) {
              touched[w] = here.tiles.mesh.F(patch.tiles[k], t);
            }
          }
        }
        for (const auto& [w, at] : touched) add_gaps(Need::corner_gap, at, -1, w);
      }
      for (int k : patch.near) {
        const int tile = patch.tiles[k];
        for (int t = 0; t < 3; ++t) add_gaps(Need::edge_gap, tile, t, k);
        for (Side side : {Side::front, Side::back}) {
          const PinRegion& clearance = pins.region(tile, side);
          const bool close = clearance.area < near_minimum * parameters_.A_pin_min;
          if (!std::isfinite(clearance.scale) || !(close || lifted.count({tile, side}))) continue;
          local.push_back(
              {{Need::tile_shape, tile, -1, side, lifted.count({tile, side}) ? goal : kept}, k});
        }
        for (int t = 0; t < 3; ++t) {
          if (here.tiles.topology.neighbour(tile, t) < tile) continue;  // each edge once
          if (std::abs(dihedral_(tile, t)) > sharp) {
            local.push_back({{Need::tile_shape, tile, t, Side::front, 0}, k});
          }
        }
      }
      if (local.empty()) continue;
      const Eigen::MatrixXd by_vertex = derivatives_by_vertex(patch, [&](const LocalGeometry& g) {
        Pins moved(g.tiles, g.truncation, parameters_);
        Eigen::VectorXd out(static_cast<Eigen::Index>(local.size()));
        for (std::size_t r = 0; r < local.size(); ++r) {
          out(static_cast<Eigen::Index>(r)) = value(local[r].first, moved, local[r].second);
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
  std::map<Need, Row> by_need;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (const Entry& entry : entries[v]) {
      by_need[entry.need].by_vertex.push_back({static_cast<int>(v), entry.derivative});
    }
  }
  std::vector<Row> out;
  for (auto& [need, row] : by_need) {
    row.value = value(need, pins, need.at);
    // Sides out of reach must not lose what they have.
    const bool of_pin = need.kind == Need::tile_shape && need.edge < 0;
    const bool out_of_reach =
        of_pin && !lifted.count({need.at, need.side}) && small.count({need.at, need.side}) != 0;
    if (out_of_reach || (!of_pin && need.share == gap_kept)) row.value = std::max(0.0, row.value);
    out.push_back(std::move(row));
  }
  return out;
}

bool ClearanceProgram::step(const std::vector<Row>& rows, const std::vector<int>& vertices,
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
