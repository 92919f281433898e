// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/target_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/refinement/clearance_program.hpp"

namespace curveups {
namespace {

constexpr int most_steps = 60;  // with a boundary that stays, and with one that may move
// Steps without an improvement after which what remains is out of reach.
constexpr int patience = 8;
constexpr double largest_step_of_L = 1.0 / 14;  // as far as folds are nearly linear in moves

// Distance of a surface from one that tiles can be, first by tiles that can't be made.
struct Shortfall {
  std::size_t impossible;  // tiles without a back face, pairs that no plane parts
  double clearance;        // missing, mm

  bool operator<(const Shortfall& o) const {
    return impossible != o.impossible ? impossible < o.impossible : clearance < o.clearance - 1e-3;
  }
};

Shortfall shortfall(const ClearanceProgram& program, const DesignGeometry& here) {
  Shortfall out{here.truncation.unresolved.size(), program.missing(here)};
  // Tiles without back faces hide the pairs: they weigh more than any number of these.
  if (!here.shaped) {
    out.impossible = 1000000 + tiles_without_back(here.tiles).size();
  }
  return out;
}

// Vertices that may move for these sides: of three rings of tiles around them, but for fixed ones.
std::vector<int> free_vertices(const PinSides& sides, const TriangleMesh& mesh,
                               const std::vector<char>& fixed) {
  std::vector<char> near(mesh.V.rows(), 0);
  for (int v : vertices_around(sides, mesh)) near[v] = 1;
  PinSides wider;
  for (int i = 0; i < mesh.F.rows(); ++i) {
    if (near[mesh.F(i, 0)] && near[mesh.F(i, 1)] && near[mesh.F(i, 2)]) {
      wider.insert({i, Side::front});
    }
  }
  std::vector<int> out;
  for (int v : vertices_around(wider, mesh)) {
    if (!fixed[v]) out.push_back(v);
  }
  return out;
}

// Moves corners of faces that would turn over or lose most of their area back.
void keep_faces(const TriangleMesh& before, TriangleMesh& after) {
  for (int round = 0; round < 8; ++round) {
    bool kept = true;
    for (int f = 0; f < after.F.rows(); ++f) {
      const Vec3 a = face_area_vector(before, f), b = face_area_vector(after, f);
      if (b.dot(a) > 0.5 * a.squaredNorm()) continue;
      kept = false;
      for (int t = 0; t < 3; ++t) after.V.row(after.F(f, t)) = before.V.row(after.F(f, t));
    }
    if (kept) return;
  }
  after = before;
}

// Descent to less and less shortfall; `best` has the best surface so far.
struct TargetSmoothing {
  const TriangleMesh& given;
  const ClearanceProgram& program;
  const MoveLimits limits;
  const Progress& progress;
  PinSides lacked;  // sides of the given surface without room
  Shortfall least;
  SmoothedTarget best;

  // Share of the work done: sides that have room now, or steps where no side gets it.
  double share() const {
    const std::size_t left = std::min(lacked.size(), best.remaining.size());
    return std::max(static_cast<double>(lacked.size() - left) / static_cast<double>(lacked.size()),
                    static_cast<double>(best.steps) / (2 * most_steps));
  }

  // Goes from the given surface until nothing is missing or no step helps; fixed: vertices that
  // stay.
  void improve(const std::vector<char>& fixed) {
    PinSides lifted = lacked;  // grows with sides that become short
    TriangleMesh moved = given;
    DesignGeometry here = program.geometry(moved);
    Shortfall reached = shortfall(program, here);
    for (int step = 1, since = 0; step <= most_steps && since < patience; ++step, ++since) {
      if (!keep_going(progress, "smoothing the target", share())) throw Cancelled();
      const std::vector<int> vertices = free_vertices(lifted, given, fixed);
      if (vertices.empty()) return;
      const TriangleMesh before = moved;
      const bool moves =
          program.step(program.rows(here, lifted, lifted, vertices), vertices, limits, moved);
      keep_faces(before, moved);
      here = program.geometry(moved);
      std::vector<SmallPin> lacking = program.lacking(here);
      const bool done = lacking.empty();
      for (const PinSide& side : sides_of(lacking)) lifted.insert(side);
      const Shortfall now = shortfall(program, here);
      ++best.steps;
      if (now < reached) {
        reached = now;
        since = 0;
      }
      if (now < least) {
        least = now;
        best.mesh = moved;
        best.remaining = std::move(lacking);
        best.overlapping = here.truncation.unresolved;
      }
      if (done || !moves) return;
    }
  }
};

}  // namespace

SmoothedTarget smooth_target(const TriangleMesh& mesh, const Edges& cuts, const Edges& kept,
                             double largest_move, const Parameters& parameters,
                             const Progress& progress) {
  if (!(largest_move >= 0) || !std::isfinite(largest_move)) {
    throw InvalidInput("the surface can't be moved by that much", "give mend_max in mm");
  }
  const ClearanceProgram program(mesh, cuts, parameters, true);
  const DesignGeometry here = program.geometry(mesh);
  const std::vector<SmallPin> lacking = program.lacking(here);
  // Coordinates are bounded one by one: the corner of their box is largest_move away.
  const MoveLimits limits{largest_step_of_L * parameters.L, largest_move / std::sqrt(3.0)};
  TargetSmoothing smoothing{
      mesh, program, limits, progress, sides_of(lacking), shortfall(program, here), {}};
  SmoothedTarget& out = smoothing.best;
  out.mesh = mesh;
  out.move.assign(mesh.V.rows(), 0);
  out.remaining = lacking;
  out.overlapping = here.truncation.unresolved;
  if (lacking.empty() || largest_move == 0) return out;

  std::vector<char> kept_only(mesh.V.rows(), 0);
  for (Eigen::Index k = 0; k < kept.size(); ++k) kept_only[kept.data()[k]] = 1;
  std::vector<char> fixed = boundary_vertices(here.tiles.topology, mesh.V.rows());
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) fixed[v] |= kept_only[v];
  smoothing.improve(fixed);
  if (!out.remaining.empty()) smoothing.improve(kept_only);
  for (int v = 0; v < mesh.V.rows(); ++v) out.move[v] = (out.mesh.V.row(v) - mesh.V.row(v)).norm();
  const PinSides small = sides_of(out.remaining);
  for (const SmallPin& pin : lacking) {
    if (!small.count({pin.tile, pin.side})) out.fixed.push_back(pin);
  }
  return out;
}

}  // namespace curveups
