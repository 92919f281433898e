// SPDX-License-Identifier: LGPL-2.1-or-later
// Nested dissection of a graph whose vertices lie near their neighbours: halves, apart by the
// fewest vertices that take all paths between them away, then halves of halves (A. George, Nested
// dissection of a regular finite element mesh, 1973; R. Lipton, D. Rose, R. Tarjan, Generalized
// nested dissection, 1979). A factorization of the parts in their order fills in little, and parts
// below different separators know nothing of one another.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace curveups {

// Where vertices lie: a row each, of two or three coordinates. They only choose which halves are
// tried: any give an order, those of vertices near their neighbours a good one.
using Places = Eigen::MatrixXd;

// The number of each vertex's part. Those that separate others have higher numbers than these.
// above[v]: the neighbours of v with higher numbers.
std::vector<int> dissected_parts(const std::vector<std::vector<int>>& above, const Places& places);

}  // namespace curveups
