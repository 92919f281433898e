// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/height_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curveups/geometry/edge_sides.hpp"

namespace curveups {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

// A point by its distances inwards from the three sides of a triangle, and its height over it, mm.
struct Placed {
  Vec3 inside = Vec3::Zero();
  double height = 0;
};

class Prism {
 public:
  explicit Prism(const std::array<Vec3, 3>& triangle) : from_(triangle) {
    const Vec3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    has_area_ = across.squaredNorm() > 0;
    normal_ = across.normalized();
    double size = 0;
    for (int t = 0; t < 3; ++t) {
      const Vec3 along = triangle[next3(t)] - triangle[t];
      inwards_[t] = normal_.cross(along).normalized();
      size = std::max(size, along.norm());
    }
    slack_ = 1e-9 * size;
  }

  bool has_area() const { return has_area_; }
  const Vec3& normal() const { return normal_; }

  Placed place(const Vec3& at) const {
    Placed out;
    for (int t = 0; t < 3; ++t) out.inside(t) = inwards_[t].dot(at - from_[t]) + slack_;
    out.height = normal_.dot(at - from_[0]);
    return out;
  }

 private:
  std::array<Vec3, 3> from_, inwards_;
  Vec3 normal_;
  double slack_ = 0;
  bool has_area_ = false;
};

// Whether part of the segment is over the triangle.
bool passes(const Placed& a, const Placed& b) {
  double begin = 0, end = 1;
  for (int t = 0; t < 3; ++t) {
    const double p = a.inside(t), q = b.inside(t);
    if (p < 0 && q < 0) return false;
    if (p < 0) begin = std::max(begin, p / (p - q));
    if (q < 0) end = std::min(end, p / (p - q));
  }
  return begin <= end;
}

// The largest height, up or down, of the part of a face that is over the triangle; negative where
// there is none.
double largest_height(const std::array<Placed, 3>& face) {
  std::array<Placed, 12> now, next;  // at most 9, whatever the rounding
  std::copy(face.begin(), face.end(), now.begin());
  int count = 3;
  for (int t = 0; t < 3; ++t) {
    int kept = 0;
    for (int k = 0; k < count; ++k) {
      const Placed &a = now[k], &b = now[k + 1 == count ? 0 : k + 1];
      const double p = a.inside(t), q = b.inside(t);
      if (p >= 0) next[kept++] = a;
      if ((p < 0) == (q < 0)) continue;
      const double share = p / (p - q);
      next[kept++] = {(1 - share) * a.inside + share * b.inside,
                      (1 - share) * a.height + share * b.height};
    }
    count = kept;
    std::swap(now, next);
  }
  double largest = -1;
  for (int k = 0; k < count; ++k) largest = std::max(largest, std::abs(now[k].height));
  return largest;
}

}  // namespace

HeightBound::HeightBound(const TriangleMesh& surface)
    : surface_(surface), beyond_(Triangles::Constant(surface.F.rows(), 3, -1)) {
  visit_edges(surface.F, static_cast<int>(surface.V.rows()),
              [&](const EdgeSide* begin, const EdgeSide* end) {
                if (end - begin != 2) return;
                beyond_(begin[0].face, begin[0].side) = begin[1].face;
                beyond_(begin[1].face, begin[1].side) = begin[0].face;
              });
}

// The faces over the triangle are followed from one to the next. Where none of them ends there, and
// all look the same way, their projection onto the triangle is open and closed, so that they cover
// it.
double HeightBound::operator()(const std::array<Vec3, 3>& triangle, int face, double most) const {
  const Prism prism(triangle);
  if (!prism.has_area()) return none;
  double largest = -1, up = 0;
  std::vector<int> found = {face};
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::array<Vec3, 3> at;
    std::array<Placed, 3> placed;
    for (int t = 0; t < 3; ++t) {
      at[t] = surface_.V.row(surface_.F(found[k], t));
      placed[t] = prism.place(at[t]);
    }
    const double here = largest_height(placed);
    if (here < 0 || here > most) {
      if (k == 0 || here > most) return none;
      continue;  // touches it by rounding
    }
    const Vec3 across = (at[1] - at[0]).cross(at[2] - at[0]);
    const double upright = prism.normal().dot(across), steep = 0.1 * across.norm();
    if (k == 0) up = upright;
    if (!(up > 0 ? upright > steep : -upright > steep)) return none;
    largest = std::max(largest, here);
    for (int t = 0; t < 3; ++t) {
      if (!passes(placed[t], placed[next3(t)])) continue;
      const int other = beyond_(found[k], t);
      if (other < 0) return none;
      if (std::find(found.begin(), found.end(), other) == found.end()) found.push_back(other);
    }
  }
  return largest;
}

}  // namespace curveups
