// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/pin_relief.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/pin_bounds.hpp"
#include "curveups/design/vertex_patch.hpp"
#include "curveups/numerics/least_step.hpp"

namespace curveups {
namespace {

constexpr double largest_move_of_L = 1.0 / 30;
// Sides are lifted to a little more than A_pin_min, room for the layout; those with less than
// near_minimum times A_pin_min must not lose what they need.
constexpr double goal = 1.03, kept = 1.002, near_minimum = 1.5;
// Steps after which sides that still miss A_pin_min are given up.
constexpr int patience = 3;

// Folds sharper than this must not become sharper: they already bound insets on either side.
constexpr double sharp = 0.3;  // rad

using PinSide = std::pair<int, Side>;  // of a tile
using PinSides = std::set<PinSide>;

// By how much the linear scale of the largest pin exceeds that of `share` times A_pin_min, in mm.
double excess(const TileMesh& tiles, const Truncation& truncation, const Parameters& p, int tile,
              Side side, double share) {
  const double scale = pin_room(tiles, truncation, p, tile, side, p.p_min).scale;
  return p.L * (scale - std::sqrt(share * p.A_pin_min / tiles.area(tile)));
}

// One requirement: room for a pin, or a fold that is not to become sharper.
struct Need {
  int tile, edge;  // edge -1: of a pin
  Side side;
  double share;  // of A_pin_min
  bool operator<(const Need& o) const {
    return std::tie(tile, edge, side) < std::tie(o.tile, o.edge, o.side);
  }
};

class Relief {
 public:
  Relief(const TriangleMesh& target, const Edges& cuts, const Parameters& parameters,
         const Progress& progress)
      : target_(target), cuts_(cuts), parameters_(parameters), progress_(progress) {
    fold_ = make_tile_mesh(target, cuts, parameters.H_body).fold;
    weight_ = Eigen::VectorXd::Zero(target.V.rows());
    for (int i = 0; i < target.F.rows(); ++i) {
      const double third = face_area_vector(target, i).norm() / 3;
      for (int t = 0; t < 3; ++t) weight_(target.F(i, t)) += third;
    }
  }

  DesignGeometry geometry(const TriangleMesh& mesh) const {
    return make_geometry(mesh, cuts_, parameters_);
  }

  // The target moved as little as lets sides reach the goal. Sides out of reach leave `asked`:
  // nothing moves for them.
  TriangleMesh lift(PinSides& asked) const;

 private:
  struct Row {
    double value;  // must stay or become positive
    std::vector<std::pair<int, Vec3>> by_vertex;
  };
  // small: all sides below A_pin_min; asked: those of them to be lifted.
  std::vector<Row> rows(const DesignGeometry& here, const PinSides& small, const PinSides& asked,
                        const std::vector<int>& vertices) const;
  bool step(const std::vector<Row>& rows, const std::vector<int>& vertices,
            TriangleMesh& mesh) const;

  const TriangleMesh& target_;
  const Edges& cuts_;
  const Parameters& parameters_;
  const Progress& progress_;
  // Positive where the need is met.
  double value(const Need& need, const TileMesh& tiles, const Truncation& truncation,
               int tile) const;

  Eigen::VectorXd weight_;  // A_j of Eq. 4
  Array3 fold_;             // of the target
};

// tile: as `tiles` numbers it.
double Relief::value(const Need& need, const TileMesh& tiles, const Truncation& truncation,
                     int tile) const {
  if (need.edge < 0) return excess(tiles, truncation, parameters_, tile, need.side, need.share);
  const double before = fold_(need.tile, need.edge), now = tiles.fold(tile, need.edge);
  return 0.5 * parameters_.L * (before > 0 ? before - now : now - before);
}

std::vector<Relief::Row> Relief::rows(const DesignGeometry& here, const PinSides& small,
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

// Towards the least movement that keeps the rows; false where nothing moves any more.
bool Relief::step(const std::vector<Row>& rows, const std::vector<int>& vertices,
                  TriangleMesh& mesh) const {
  const Eigen::Index count = 3 * static_cast<Eigen::Index>(vertices.size());
  const double trust = parameters_.L / 40, limit = largest_move_of_L * parameters_.L;
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

// What may move: the vertices of the tiles around.
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

TriangleMesh Relief::lift(PinSides& asked) const {
  const PinSides small = asked;
  const std::vector<int> vertices = vertices_around(asked, target_);
  TriangleMesh mesh = target_;
  DesignGeometry here = geometry(mesh);
  for (int round = 1; !asked.empty(); ++round) {
    if (!keep_going(progress_, "making room for pins", -1)) throw Cancelled();
    const bool moved = step(rows(here, small, asked, vertices), vertices, mesh);
    try {
      here = geometry(mesh);
    } catch (const InfeasibleDesign&) {  // a tile lost its back face
      asked.clear();
      break;
    }
    PinSides reached = asked;
    bool spoiled = false;
    for (const SmallPin& pin : here.pin_bounds.small) {
      reached.erase({pin.tile, pin.side});
      spoiled = spoiled || !small.count({pin.tile, pin.side});
    }
    const bool last = !moved || round % patience == 0;
    if (reached.size() == asked.size() && (last || !spoiled)) return mesh;
    if (!last) continue;
    asked = std::move(reached);  // once more, without what moved for the others
    mesh = target_;
    here = geometry(mesh);
  }
  return target_;
}

}  // namespace

PinRelief relieve_pins(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters,
                       const Progress& progress) {
  const Relief relief(mesh, cuts, parameters, progress);
  const DesignGeometry given = relief.geometry(mesh);
  PinRelief out;
  out.mesh = mesh;
  out.remaining = given.pin_bounds.small;
  PinSides asked;
  for (const SmallPin& pin : out.remaining) asked.insert({pin.tile, pin.side});
  if (asked.empty()) return out;
  const TriangleMesh moved = relief.lift(asked);
  const DesignGeometry there = relief.geometry(moved);
  if (asked.empty() || there.pin_bounds.small.size() >= out.remaining.size() ||
      there.truncation.unresolved.size() > given.truncation.unresolved.size()) {
    return out;
  }
  PinSides small;
  for (const SmallPin& pin : there.pin_bounds.small) {
    small.insert({pin.tile, pin.side});
    // Sides out of reach must stay above the floor.
    const auto before =
        std::find_if(out.remaining.begin(), out.remaining.end(),
                     [&](const SmallPin& p) { return p.tile == pin.tile && p.side == pin.side; });
    const double area = before == out.remaining.end() ? parameters.A_pin_min : before->area;
    if (pin.area < parameters.A_pin_floor && area >= parameters.A_pin_floor) return out;
  }
  for (const SmallPin& pin : out.remaining) {
    if (!small.count({pin.tile, pin.side})) out.relieved.push_back(pin);
  }
  out.mesh = moved;
  out.largest_move = (moved.V - mesh.V).rowwise().norm().maxCoeff();
  out.remaining = there.pin_bounds.small;
  return out;
}

}  // namespace curveups
