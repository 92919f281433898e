// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/pin_smoothing.hpp"

#include <algorithm>

#include "curveups/core/errors.hpp"
#include "curveups/refinement/clearance_program.hpp"

namespace curveups {
namespace {

constexpr double largest_move_of_L = 1.0 / 30;
// Steps after which sides that still miss A_pin_min are given up.
constexpr int patience = 3;

// Moves the target as little as lets sides reach A_pin_min. Sides out of reach leave `lifted`: no
// vertex moves for them.
TriangleMesh lift(const ClearanceProgram& program, const TriangleMesh& target, double L,
                  PinSides& lifted, const Progress& progress) {
  const PinSides small = lifted;
  const std::vector<int> vertices = vertices_around(lifted, target);
  const MoveLimits limits{L / 40, largest_move_of_L * L};
  TriangleMesh mesh = target;
  DesignGeometry here = program.geometry(mesh);
  for (int round = 1; !lifted.empty(); ++round) {
    if (!keep_going(progress, "making room for pins", -1)) throw Cancelled();
    const bool moved =
        program.step(program.rows(here, small, lifted, vertices), vertices, limits, mesh);
    here = program.geometry(mesh);
    if (!here.shaped) {  // a tile lost its back face
      lifted.clear();
      break;
    }
    PinSides reached = lifted;
    bool spoiled = false;
    for (const SmallPin& pin : here.pin_bounds.small) {
      reached.erase({pin.tile, pin.side});
      spoiled = spoiled || !small.count({pin.tile, pin.side});
    }
    const bool last = !moved || round % patience == 0;
    if (reached.size() == lifted.size() && (last || !spoiled)) return mesh;
    if (!last) continue;
    lifted = std::move(reached);  // anew, without the moves for the others
    mesh = target;
    here = program.geometry(mesh);
  }
  return target;
}

}  // namespace

PinSmoothing smooth_for_pins(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters, const Progress& progress) {
  const DesignGeometry given = make_geometry(mesh, cuts, parameters);
  const ClearanceProgram program(mesh, cuts, parameters);
  PinSmoothing out;
  out.mesh = mesh;
  out.remaining = given.pin_bounds.small;
  PinSides lifted = sides_of(out.remaining);
  if (lifted.empty()) return out;
  const TriangleMesh moved = lift(program, mesh, parameters.L, lifted, progress);
  const DesignGeometry after = program.geometry(moved);
  if (lifted.empty() || after.pin_bounds.small.size() >= out.remaining.size() ||
      after.truncation.unresolved.size() > given.truncation.unresolved.size()) {
    return out;
  }
  const PinSides small = sides_of(after.pin_bounds.small);
  for (const SmallPin& pin : after.pin_bounds.small) {
    // Sides out of reach must stay above the floor.
    const auto before =
        std::find_if(out.remaining.begin(), out.remaining.end(),
                     [&](const SmallPin& p) { return p.tile == pin.tile && p.side == pin.side; });
    const double area = before == out.remaining.end() ? parameters.A_pin_min : before->area;
    if (pin.area < parameters.A_pin_floor && area >= parameters.A_pin_floor) return out;
  }
  for (const SmallPin& pin : out.remaining) {
    if (!small.count({pin.tile, pin.side})) out.reached.push_back(pin);
  }
  out.mesh = moved;
  out.largest_move = (moved.V - mesh.V).rowwise().norm().maxCoeff();
  out.remaining = after.pin_bounds.small;
  return out;
}

}  // namespace curveups
