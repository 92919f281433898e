// SPDX-License-Identifier: LGPL-2.1-or-later
// Membranes and least-squares contact forces of one design whose pins move: on the coarser mesh of
// verification, whose topology and weights stay, each equilibrium started from the last.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "curveups/physics/solved_design.hpp"

namespace curveups {

class DesignForces {
 public:
  // solved: the membranes for these poses and q. Throws what solve_contact_forces throws,
  // SolverFailure where an equilibrium is not found. geometry must outlive this.
  DesignForces(const DesignGeometry& geometry, const Parameters& parameters,
               std::array<SolvedMembrane, 2> solved, const FlatPoses& poses, const Array6& q);

  // Follow other poses, insets and vertices on the same mesh. geometry: of the same tiles and cuts;
  // must outlive this. Throws InvalidInput where a triangle of the mesh turns over (then mesh
  // again), SolverFailure, Cancelled; nothing here is valid then until the next successful move.
  void move(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
            const Progress& progress);

  const DesignGeometry& geometry() const { return *geometry_; }
  const Parameters& parameters() const { return parameters_; }
  const FlatPoses& poses() const { return poses_; }
  const Array6& insets() const { return q_; }
  const SolvedMembrane& membrane(Side side) const { return membranes_[static_cast<int>(side)]; }
  // Factorized at that membrane's state, or within the last step to it.
  const MembraneEquilibrium& equilibrium(Side side) const {
    return *equilibria_[static_cast<int>(side)];
  }
  // Balance with the factorization of A A^T.
  const BalanceSystem& system() const { return *system_; }
  const Wrenches& loads() const { return loads_; }
  const ContactForces& contact_forces() const { return forces_; }

 private:
  void solve_contacts();
  void take_geometry(const DesignGeometry& geometry);

  const DesignGeometry* geometry_ = nullptr;
  Parameters parameters_;
  FlatPoses poses_;
  Array6 q_;
  std::array<SolvedMembrane, 2> membranes_;
  std::array<std::unique_ptr<MembraneEquilibrium>, 2> equilibria_;
  std::optional<BalanceSystem> system_;
  Wrenches loads_;
  ContactForces forces_;
};

}  // namespace curveups
