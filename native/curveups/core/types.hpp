// SPDX-License-Identifier: LGPL-2.1-or-later
// Eigen aliases shared by all rooms. Arrays are row-major, as numpy's.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace curveups {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Array3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  // three per tile
using Array6 = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;  // six per tile
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Edges = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

// Scalar cross product a ^ b = a.x b.y - a.y b.x.
inline double wedge(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// The vector turned by +90 degrees: to the left of its direction.
inline Vec2 left_of(const Vec2& a) { return Vec2(-a.y(), a.x()); }

inline int next3(int t) { return t == 2 ? 0 : t + 1; }
inline int prev3(int t) { return t == 0 ? 2 : t - 1; }

}  // namespace curveups
