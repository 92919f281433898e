// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/boundary_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace curveups {

BoundaryCurves::BoundaryCurves(const TriangleMesh& mesh) {
  for (std::vector<int>& loop :
       boundary_loops(build_topology(mesh.F, static_cast<int>(mesh.V.rows())))) {
    Curve curve;
    curve.arc.push_back(0);
    for (std::size_t i = 0; i <= loop.size(); ++i) {
      curve.point.push_back(mesh.V.row(loop[i % loop.size()]));
      if (i > 0)
        curve.arc.push_back(curve.arc.back() + (curve.point[i] - curve.point[i - 1]).norm());
    }
    curve.vertex = std::move(loop);
    curves_.push_back(std::move(curve));
  }
}

std::vector<int> BoundaryCurves::corners(double angle) const {
  std::vector<int> found;
  for (const Curve& curve : curves_) {
    const int count = static_cast<int>(curve.vertex.size());
    for (int i = 0; i < count; ++i) {
      const Vec3 in = curve.point[i] - curve.point[(i + count - 1) % count];
      const Vec3 out = curve.point[i + 1] - curve.point[i];
      if (std::atan2(in.cross(out).norm(), in.dot(out)) > angle) found.push_back(curve.vertex[i]);
    }
  }
  return found;
}

BoundaryCurves::Place BoundaryCurves::nearest(const Vec3& p) const {
  Place best{-1, 0, std::numeric_limits<double>::infinity()};
  for (int c = 0; c < count(); ++c) {
    const Curve& curve = curves_[c];
    for (std::size_t i = 0; i + 1 < curve.point.size(); ++i) {
      const Vec3 d = curve.point[i + 1] - curve.point[i];
      const double squared = d.squaredNorm();
      const double t =
          squared > 0 ? std::clamp((p - curve.point[i]).dot(d) / squared, 0.0, 1.0) : 0.0;
      const double distance = (curve.point[i] + t * d - p).norm();
      if (distance < best.distance) {
        best = {c, curve.arc[i] + t * (curve.arc[i + 1] - curve.arc[i]), distance};
      }
    }
  }
  return best;
}

Vec3 BoundaryCurves::at(int c, double arc) const {
  const Curve& curve = curves_[c];
  const double length = curve.arc.back();
  arc -= length * std::floor(arc / length);
  const auto above = std::upper_bound(curve.arc.begin(), curve.arc.end(), arc);
  const std::size_t i = std::min<std::size_t>(
      std::max<std::ptrdiff_t>(above - curve.arc.begin() - 1, 0), curve.point.size() - 2);
  const double step = curve.arc[i + 1] - curve.arc[i];
  const double t = step > 0 ? std::clamp((arc - curve.arc[i]) / step, 0.0, 1.0) : 0.0;
  return (1 - t) * curve.point[i] + t * curve.point[i + 1];
}

}  // namespace curveups
