// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/design_forces.hpp"

#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {

DesignForces::DesignForces(const DesignGeometry& geometry, const Parameters& parameters,
                           std::array<SolvedMembrane, 2> solved, const FlatPoses& poses,
                           const Array6& q)
    : parameters_(parameters), poses_(poses), q_(q), membranes_(std::move(solved)) {
  take_geometry(geometry);
  parallel_for(2, [&](int s) {
    const Side side = static_cast<Side>(s);
    equilibria_[s] = std::make_unique<MembraneEquilibrium>(
        membrane_equilibrium(membranes_[s], parameters, side));
    if (!equilibria_[s]->factorize(membranes_[s].state.x)) throw no_equilibrium(side);
  });
  solve_contacts();
}

void DesignForces::take_geometry(const DesignGeometry& geometry) {
  geometry_ = &geometry;
  system_.emplace(make_balance_system(geometry, parameters_));
}

void DesignForces::move(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
                        const Progress& progress) {
  take_geometry(geometry);
  poses_ = poses;
  q_ = q;
  auto solve = [&](Side side, const Progress& sink) {
    SolvedMembrane& m = membranes_[static_cast<int>(side)];
    m.flat_corners = flat_pin_corners(geometry.tiles, poses, q, side);
    MembraneEquilibrium& equilibrium = *equilibria_[static_cast<int>(side)];
    equilibrium.set_rest(m.flat(), parameters_.tau);
    move_pins(m, equilibrium, actuated_pin_corners(geometry.tiles, q, side, parameters_.H_pin),
              sink);
    if (!m.state.solve.stopped() && !equilibrium.factorize(m.state.x)) throw no_equilibrium(side);
  };
  // The progress sink is called from one thread only; the other membrane ends by itself.
  parallel_for(2, [&](int s) { solve(static_cast<Side>(s), s == 0 ? progress : Progress()); });
  if (membrane(Side::front).state.solve.stopped()) throw Cancelled();
  solve_contacts();
}

void DesignForces::solve_contacts() {
  loads_ = weights(*geometry_, q_, parameters_);
  loads_ += carry(*geometry_, loads_, parameters_).table;
  for (Side side : {Side::front, Side::back}) {
    const SolvedMembrane& m = membrane(side);
    // Rounding alone may keep a membrane from the last digits of its tolerance.
    if (!(m.state.solve.residual < 1e-6)) throw no_equilibrium(side);
    loads_ += membrane_wrenches(m.mesh, m.state, system_->centres());
  }
  forces_ = solve_contact_forces(*system_, loads_);
}

}  // namespace curveups
