// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/slab.hpp"

#include <algorithm>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/fabrication/face_division.hpp"

namespace curveups {
namespace {

// Copies single points and circles of a body into the slab, each once.
class Importer {
 public:
  Importer(PrintBody& slab, const PrintBody& from)
      : slab_(slab),
        from_(from),
        point_(from.points.size(), -1),
        circle_(from.circles.size(), -1) {}

  std::vector<int> points(const std::vector<int>& loop) {
    std::vector<int> out;
    for (int i : loop) {
      if (point_[i] < 0) {
        point_[i] = static_cast<int>(slab_.points.size());
        slab_.points.push_back(from_.points[i]);
      }
      out.push_back(point_[i]);
    }
    return out;
  }

  int circle(int i) {
    if (circle_[i] < 0) {
      circle_[i] = static_cast<int>(slab_.circles.size());
      slab_.circles.push_back(from_.circles[i]);
    }
    return circle_[i];
  }

  BodyLoop reversed_loop(const BodyLoop& loop) {
    BodyLoop out;
    if (loop.circle >= 0) {
      out.circle = circle(loop.circle);
    } else {
      out.points = points(loop.points);
      std::reverse(out.points.begin(), out.points.end());
    }
    return out;
  }

  bool has_circle(int i) const { return circle_[i] >= 0; }

 private:
  PrintBody& slab_;
  const PrintBody& from_;
  std::vector<int> point_, circle_;
};

bool surrounded(FaceRole role) {
  return role == FaceRole::wall || role == FaceRole::cut || role == FaceRole::back ||
         role == FaceRole::back_pin;
}

void add_cavity(PrintBody& slab, PlanarFace& bottom, PlanarFace& lid, const PrintBody& body,
                double top) {
  Importer import(slab, body);
  for (const PlanarFace& face : body.faces) {
    if (face.role == FaceRole::foot) {
      bottom.inner.push_back(import.reversed_loop(face.outer));
    } else if (face.role == FaceRole::front) {
      BodyLoop mouth = import.reversed_loop(face.outer);
      const double rise = top - slab.points[mouth.points[0]].z();
      if (rise > tolerance::snap) {
        mouth.points = extrude(slab, mouth.points, Vec3(0, 0, rise), FaceRole::plain);
      }
      lid.inner.push_back(std::move(mouth));
    } else if (surrounded(face.role)) {
      PlanarFace wall;
      wall.normal = -face.normal;
      wall.outer = import.reversed_loop(face.outer);
      for (const BodyLoop& loop : face.inner) wall.inner.push_back(import.reversed_loop(loop));
      slab.faces.push_back(std::move(wall));
    }
  }
  for (const SphericalCap& cap : body.caps) {
    if (!import.has_circle(cap.circle)) continue;
    slab.caps.push_back({import.circle(cap.circle), cap.axis, cap.height, !cap.bump});
  }
}

}  // namespace

PrintBody make_slab(const std::vector<Polygon>& outline, const std::vector<PrintBody>& cavities,
                    const std::vector<Vec2>& bores, double bore_radius, double top) {
  PrintBody slab;
  slab.kind = BodyKind::support;
  PlanarFace bottom, lid;
  bottom.normal = -Vec3::UnitZ();
  lid.normal = Vec3::UnitZ();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    auto [below, above] = add_walls(slab, outline[k], top);
    (k == 0 ? lid.outer : lid.inner.emplace_back()) = std::move(above);
    (k == 0 ? bottom.outer : bottom.inner.emplace_back()) = std::move(below);
  }
  for (const PrintBody& body : cavities) {
    checkpoint();
    add_cavity(slab, bottom, lid, body, top);
  }
  for (const Vec2& bore : bores) {
    const Vec3 foot(bore.x(), bore.y(), 0);
    BodyLoop below, above;
    below.circle = static_cast<int>(slab.circles.size());
    slab.circles.push_back({foot, Vec3::UnitZ(), bore_radius});
    above.circle = below.circle + 1;
    slab.circles.push_back({foot + Vec3(0, 0, top), Vec3::UnitZ(), bore_radius});
    slab.cylinders.push_back({below.circle, above.circle, false});
    bottom.inner.push_back(std::move(below));
    lid.inner.push_back(std::move(above));
  }
  checkpoint("dividing the support's underside", 0.7);
  add_divided(slab, bottom);
  checkpoint("dividing the support's lid", 0.8);
  add_divided(slab, lid);
  return slab;
}

}  // namespace curveups
