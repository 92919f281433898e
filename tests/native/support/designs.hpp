// SPDX-License-Identifier: LGPL-2.1-or-later
// Small whole designs with a spread-out flat layout, made without an optimiser.
#pragma once

#include <functional>

#include "curveups/design/design.hpp"

namespace curveups::test {

struct SampleOptions {
  int rows = 4, columns = 5;
  double kx = 0.012, ky = 0.012;  // z = -(kx x^2 + ky y^2) / 2: a dome; opposite signs: a saddle
  double spread = 1.45;
  Edges cuts = Edges(0, 2);
  double piece_offset = 0;  // moves tiles with an x of the plan above 0 further right
  // Only triangles whose centre's plan this accepts; cuts are then by the numbers that remain.
  std::function<bool(const Vec2&)> keep = {};
};

// A curved patch over a triangular grid, its tiles laid out rigidly where the patch's plan has
// them, spread apart; pins a little within their bounds.
Design sample_design(const Parameters& parameters = {}, const SampleOptions& o = {});

// Every tile placed rigidly over its projection to the xy plane, which is spread by `spread`.
Design spread_design(const TriangleMesh& mesh, double spread, double inset);

}  // namespace curveups::test
