// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction needed for balance, as a least-squares objective. Among all forces (n, t) at the contact
// points that balance the loads b, those with the least tangential part have
//   Phi = min sum 1/2 |t|^2 + e/2 n^2 + 1/2 [floor - n]+^2  subject to  A f + b = 0,  e small.
// Where Phi is zero but for e, normal forces alone hold the tiles where they are: the target is
// where the piece comes to rest without friction. Under the active floors, Phi follows small steps
// d of the unknowns by Gauss and Newton, 1/2 (r + J d) . S^-1 (r + J d) with S = A D^-1 A^T.
#pragma once

#include "curveups/physics/design_forces.hpp"
#include "curveups/refinement/iterate.hpp"
#include "curveups/refinement/layout_step.hpp"

namespace curveups {

class FrictionObjective {
 public:
  // loads: on all tiles, N. unit: mean normal force, N.
  FrictionObjective(const DesignGeometry& geometry, const Parameters& parameters,
                    const FlatPoses& poses, const Wrenches& loads, double unit);

  double value() const { return value_; }  // Phi, in squares of the unit
  // Root mean square of the tangential forces, in the unit.
  double tangential() const;
  // Linearises for steps of all tiles' unknowns from `place`, whose loads follow `forces`. The
  // result refers to this.
  StepObjective linearise(const Iterate& place, const DesignForces& forces) const;

 private:
  void find_forces(const Wrenches& loads);
  SparseRows jacobian(const Iterate& place, const DesignForces& forces) const;

  BalanceSystem system_;
  double unit_, value_ = 0;
  Eigen::VectorXd right_;  // b and the terms of active floors
  Points3 force_;          // per point in its basis, N
};

}  // namespace curveups
