// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/body_checks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

struct Circle {
  Vec2 centre;
  double radius;
};

struct Segment {
  Vec2 begin, end;
  int loop, index;  // place in its loop
  int count;        // segments of that loop
  double low() const { return std::min(begin.x(), end.x()); }
  double high() const { return std::max(begin.x(), end.x()); }
};

// Side of c with respect to the line from a to b: 1 left, -1 right, 0 on it.
int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double area = wedge(b - a, c - a);
  return (area > 0) - (area < 0);
}

bool is_between(const Vec2& a, const Vec2& b, const Vec2& c) { return (c - a).dot(c - b) <= 0; }

// True where two segments have a point in common.
bool meet(const Segment& s, const Segment& t) {
  const int a = side(s.begin, s.end, t.begin), b = side(s.begin, s.end, t.end),
            c = side(t.begin, t.end, s.begin), d = side(t.begin, t.end, s.end);
  if (a * b < 0 && c * d < 0) return true;
  return (a == 0 && is_between(s.begin, s.end, t.begin)) ||
         (b == 0 && is_between(s.begin, s.end, t.end)) ||
         (c == 0 && is_between(t.begin, t.end, s.begin)) ||
         (d == 0 && is_between(t.begin, t.end, s.end));
}

// True where two segments of a loop that share an end lie on one another.
bool fold_back(const Segment& s, const Segment& next) {
  const Vec2 a = s.end - s.begin, b = next.end - next.begin;
  return wedge(a, b) == 0 && a.dot(b) <= 0;
}

// True where a ray from the point crosses an odd number of the segments of a loop.
bool encloses(const std::vector<Segment>& segments, int loop, const Vec2& p) {
  bool inside = false;
  for (const Segment& s : segments) {
    if (s.loop != loop || (s.begin.y() > p.y()) == (s.end.y() > p.y())) continue;
    const bool left = side(s.begin, s.end, p) > 0;
    inside = inside != (left == (s.end.y() > s.begin.y()));
  }
  return inside;
}

// Boundaries of a face in its own plane; loop 0 is the outer one.
class FaceBoundary {
 public:
  FaceBoundary(const PrintBody& body, const PlanarFace& face) {
    const Vec3 u = face.normal.unitOrthogonal(), v = face.normal.cross(u);
    const auto flat = [&](const Vec3& p) { return Vec2(u.dot(p), v.dot(p)); };
    add(body, face.outer, flat);
    for (const BodyLoop& loop : face.inner) add(body, loop, flat);
  }

  bool crosses() {
    std::sort(segments_.begin(), segments_.end(),
              [](const Segment& a, const Segment& b) { return a.low() < b.low(); });
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      for (std::size_t j = i + 1; j < segments_.size() && segments_[j].low() <= segments_[i].high();
           ++j) {
        if (conflict(segments_[i], segments_[j])) return true;
      }
      for (const auto& circle : circles_) {
        if (circle && segment_distance(segments_[i].begin, segments_[i].end, circle->centre) <=
                          circle->radius) {
          return true;
        }
      }
    }
    for (std::size_t i = 1; i < circles_.size(); ++i) {
      for (std::size_t j = i + 1; j < circles_.size(); ++j) {
        if (circles_[i] && circles_[j] &&
            (circles_[i]->centre - circles_[j]->centre).norm() <=
                circles_[i]->radius + circles_[j]->radius) {
          return true;
        }
      }
    }
    return false;
  }

  // True where a hole is not inside of the outer boundary, or is inside of another hole.
  bool has_stray_hole() const {
    for (int hole = 1; hole < loops(); ++hole) {
      const Vec2 p = circles_[hole] ? circles_[hole]->centre : start_[hole];
      for (int loop = 0; loop < loops(); ++loop) {
        if (loop == hole) continue;
        const bool inside = circles_[loop] ? (p - circles_[loop]->centre).norm() +
                                                     (circles_[hole] ? circles_[hole]->radius : 0) <
                                                 circles_[loop]->radius
                                           : encloses(segments_, loop, p);
        if (inside != (loop == 0)) return true;
      }
    }
    return false;
  }

 private:
  template <class Flat>
  void add(const PrintBody& body, const BodyLoop& loop, const Flat& flat) {
    const int number = loops();
    if (loop.circle >= 0) {
      const BodyCircle& c = body.circles[loop.circle];
      circles_.push_back(Circle{flat(c.centre), c.radius});
      start_.push_back(circles_.back()->centre);
      return;
    }
    circles_.emplace_back();
    start_.push_back(flat(body.points[loop.points[0]]));
    const int count = static_cast<int>(loop.points.size());
    for (int k = 0; k < count; ++k) {
      segments_.push_back({flat(body.points[loop.points[k]]),
                           flat(body.points[loop.points[(k + 1) % count]]), number, k, count});
    }
  }

  static bool conflict(const Segment& s, const Segment& t) {
    if (s.loop == t.loop) {
      if ((s.index + 1) % s.count == t.index) return fold_back(s, t);
      if ((t.index + 1) % t.count == s.index) return fold_back(t, s);
    }
    return meet(s, t);
  }

  int loops() const { return static_cast<int>(circles_.size()); }

  std::vector<Segment> segments_;
  std::vector<std::optional<Circle>> circles_;  // circle of each loop; none for a polygon
  std::vector<Vec2> start_;                     // a point of each loop
};

constexpr double parallel_tolerance = 1e-9;  // unit vectors

bool parallel(const Vec3& a, const Vec3& b) { return a.cross(b).norm() < parallel_tolerance; }

class BodyCheck {
 public:
  explicit BodyCheck(const PrintBody& body) : body_(body), turns_(body.circles.size()) {}

  std::string run() {
    if (!is_finite()) return "invalid";
    for (const PlanarFace& face : body_.faces) {
      if (!is_flat(face)) return "not flat";
      FaceBoundary boundary(body_, face);
      if (boundary.crosses() || boundary.has_stray_hole()) return "a face crosses itself";
      if (!is_directed(face)) return "faces turned over";
      list_edges(face);
    }
    if (!edges_match() || !circles_match()) return "open";
    return volume(body_) > 0 ? "" : "no volume";
  }

 private:
  bool is_finite() const {
    return std::all_of(body_.points.begin(), body_.points.end(),
                       [](const Vec3& p) { return p.allFinite(); }) &&
           std::all_of(body_.circles.begin(), body_.circles.end(), [](const BodyCircle& c) {
             return c.centre.allFinite() && c.radius > 0 && std::abs(c.axis.norm() - 1) < 1e-9;
           });
  }

  bool is_flat(const PlanarFace& face) const {
    if (std::abs(face.normal.norm() - 1) > 1e-9) return false;
    std::optional<double> height;
    const auto lies = [&](const BodyLoop& loop) {
      if (loop.circle >= 0) {
        const BodyCircle& c = body_.circles[loop.circle];
        return parallel(c.axis, face.normal) && is_level(face.normal.dot(c.centre), height);
      }
      return loop.points.size() > 2 &&
             std::all_of(loop.points.begin(), loop.points.end(),
                         [&](int i) { return is_level(face.normal.dot(body_.points[i]), height); });
    };
    return lies(face.outer) && std::all_of(face.inner.begin(), face.inner.end(), lies);
  }

  static bool is_level(double at, std::optional<double>& height) {
    if (!height) height = at;
    return std::abs(at - *height) <= tolerance::snap;
  }

  // Outer boundaries run counter-clockwise, inner ones clockwise.
  bool is_directed(const PlanarFace& face) const {
    PlanarFace alone;
    alone.normal = face.normal;
    const auto area = [&](const BodyLoop& loop) {
      alone.outer = loop;
      return face_area(body_, alone);
    };
    return area(face.outer) > 0 &&
           std::all_of(face.inner.begin(), face.inner.end(),
                       [&](const BodyLoop& loop) { return loop.circle >= 0 || area(loop) < 0; });
  }

  void list_edges(const PlanarFace& face) {
    const auto list = [&](const BodyLoop& loop, double direction) {
      if (loop.circle >= 0) turns_[loop.circle].push_back(direction * face.normal);
      for (std::size_t k = 0; k < loop.points.size(); ++k) {
        edges_.push_back({loop.points[k], loop.points[(k + 1) % loop.points.size()]});
      }
    };
    list(face.outer, 1);
    for (const BodyLoop& loop : face.inner) list(loop, -1);
  }

  // Every edge belongs to two faces, in opposite directions.
  bool edges_match() {
    std::sort(edges_.begin(), edges_.end());
    if (std::adjacent_find(edges_.begin(), edges_.end()) != edges_.end()) return false;
    return std::all_of(edges_.begin(), edges_.end(), [&](const std::array<int, 2>& edge) {
      return std::binary_search(edges_.begin(), edges_.end(), std::array<int, 2>{edge[1], edge[0]});
    });
  }

  // Every circle belongs to two surfaces, in opposite directions.
  bool circles_match() {
    for (const SphericalCap& cap : body_.caps) {
      if (!(cap.height > 0)) return false;
      turns_[cap.circle].push_back((cap.bump ? 1 : -1) * cap.axis);
    }
    for (const CylinderWall& wall : body_.cylinders) {
      const BodyCircle &a = body_.circles[wall.bottom], &b = body_.circles[wall.top];
      if (std::abs(a.radius - b.radius) > tolerance::snap) return false;
      const Vec3 turn = (wall.outward ? 1 : -1) * (b.centre - a.centre).normalized();
      turns_[wall.bottom].push_back(turn);
      turns_[wall.top].push_back(-turn);
    }
    for (std::size_t k = 0; k < turns_.size(); ++k) {
      if (turns_[k].size() != 2 || (turns_[k][0] + turns_[k][1]).norm() > parallel_tolerance ||
          !parallel(turns_[k][0], body_.circles[k].axis)) {
        return false;
      }
    }
    return true;
  }

  const PrintBody& body_;
  std::vector<std::array<int, 2>> edges_;
  // Directions about which the surfaces of a circle have it counter-clockwise, by circle.
  std::vector<std::vector<Vec3>> turns_;
};

}  // namespace

std::string unsoundness(const PrintBody& body) { return BodyCheck(body).run(); }

}  // namespace curveups
