// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/touch_points.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace curveups {
namespace {

Vec3 tied_position(const std::vector<ContactPoint>& corners, const TouchPoints::Tie& tie) {
  Vec3 out = tie.height * corners[tie.first].normal;
  for (int l = 0; l < tie.count; ++l) out += tie.weight[l] * corners[tie.first + l].position;
  return out;
}

// The least weights, of sum 1, that give the tip's foot on the plane of the corners.
TouchPoints::Tie tie_tip(const std::vector<ContactPoint>& corners, int first, int count,
                         const Vec3& tip) {
  const Vec3 &origin = corners[first].position, &normal = corners[first].normal;
  TouchPoints::Tie tie{first, count, {}, normal.dot(tip - origin)};
  Eigen::Matrix<double, 4, Eigen::Dynamic> system(4, count);
  for (int l = 0; l < count; ++l) {
    system.col(l) << corners[first + l].position - origin, 1;
  }
  Eigen::Vector4d right;
  right << tip - tie.height * normal - origin, 1;
  const Eigen::VectorXd weight = system.completeOrthogonalDecomposition().solve(right);
  for (int l = 0; l < count; ++l) tie.weight[l] = weight(l);
  return tie;
}

}  // namespace

bool any_tips(const std::vector<Points3>& tips) {
  return std::any_of(tips.begin(), tips.end(), [](const Points3& at) { return at.rows() > 0; });
}

TouchPoints tie_to_corners(const std::vector<ContactPoint>& corners,
                           const std::vector<Points3>& tips) {
  TouchPoints out;
  const int size = static_cast<int>(corners.size());
  for (int first = 0, next = 0; first < size; first = next) {
    const ContactPoint& corner = corners[first];
    while (next < size && corners[next].contact == corner.contact) ++next;
    const Points3& here = tips[corner.contact];
    for (int p = 0; p < here.rows(); ++p) {
      out.points.push_back({here.row(p).transpose(), corner.normal, corner.tile, corner.contact});
      out.tie.push_back(tie_tip(corners, first, next - first, here.row(p).transpose()));
    }
    for (int p = first; p < next && here.rows() == 0; ++p) {
      out.points.push_back(corners[p]);
      out.tie.push_back({p, 1, {1, 0, 0, 0}, 0});
    }
  }
  return out;
}

bool follow_corners(const std::vector<ContactPoint>& corners, TouchPoints& touch) {
  for (std::size_t p = 0; p < touch.points.size(); ++p) {
    const TouchPoints::Tie& tie = touch.tie[p];
    const std::size_t last = static_cast<std::size_t>(tie.first + tie.count - 1);
    if (last >= corners.size() || corners[tie.first].contact != touch.points[p].contact ||
        corners[last].contact != touch.points[p].contact) {
      return false;
    }
  }
  for (std::size_t p = 0; p < touch.points.size(); ++p) {
    const TouchPoints::Tie& tie = touch.tie[p];
    touch.points[p].position = tied_position(corners, tie);
    touch.points[p].normal = corners[tie.first].normal;
  }
  return true;
}

}  // namespace curveups
