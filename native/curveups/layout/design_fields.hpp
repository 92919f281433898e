// SPDX-License-Identifier: LGPL-2.1-or-later
// Values of a layout for each contact and tile that need no membranes.
#pragma once

#include "curveups/design/design.hpp"
#include "curveups/layout/target_fields.hpp"

namespace curveups {

struct DesignFields {
  Edges contacts;                // N x 2 tiles
  Eigen::VectorXd gap;           // N, mm: what Eq. 7 bounds, see contact_gaps
  Eigen::VectorXd spring_force;  // N, see spring_forces.hpp
  std::vector<int> weak;         // contacts that the springs hold too weakly
  PerSide pin_area;              // M, mm2; negative where insets turn a pin over
  PerSide
      membrane_slack;  // N, front and back: rest over actuated length (Eq. 16); above 1 it is slack
};

// Throws InvalidInput where T or q have other sizes or are not finite, and what make_geometry
// throws.
DesignFields design_fields(const Design& design);

}  // namespace curveups
