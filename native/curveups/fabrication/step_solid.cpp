// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "curveups/core/checkpoint.hpp"
#include "curveups/fabrication/step_text.hpp"

namespace curveups {
namespace {

// Far above the rounding of unit vectors. Over the 500 mm of a slab it is less than a thousandth of
// the accuracy that files declare.
constexpr double direction_step = 1e-11;

class SolidWriter {
 public:
  SolidWriter(StepText& step, const PrintBody& body)
      : step_(step), body_(body), vertex_(body.points.size()), circle_(body.circles.size()) {}

  StepId run() {
    // Curved faces first: they determine the directions of their circles.
    for (const SphericalCap& cap : body_.caps) add_cap(cap);
    for (const CylinderWall& wall : body_.cylinders) add_cylinder(wall);
    for (const PlanarFace& face : body_.faces) {
      checkpoint();  // a slab has tens of thousands
      add_planar(face);
    }
    const StepId shell = step_.add("CLOSED_SHELL('',", in_connected_order(), ")");
    return step_.add("MANIFOLD_SOLID_BREP(", step_string(body_.name), ",", shell, ")");
  }

 private:
  struct Vertex {
    StepId point{}, vertex{};
  };
  // A whole circle as a closed edge from `start`, counter-clockwise about `axis`.
  struct Circle {
    Vertex start;
    StepId edge{};
    Vec3 axis, x;
  };

  StepId point(const Vec3& p) { return step_.add("CARTESIAN_POINT('',", p, ")"); }

  // Directions that differ by rounding alone share an entity: most edges are parallel to others.
  StepId direction(const Vec3& d) {
    std::array<long long, 3> key;
    for (int k = 0; k < 3; ++k) key[k] = std::llround(d[k] / direction_step);
    StepId& id = direction_[key];
    if (id == StepId{}) id = step_.add("DIRECTION('',", d, ")");
    return id;
  }

  StepId vector(const Vec3& d) {
    const StepId along = direction(d);
    StepId& id = vector_[static_cast<int>(along)];
    if (id == StepId{}) id = step_.add("VECTOR('',", along, ",1.)");
    return id;
  }

  StepId placement(StepId origin, const Vec3& axis, const Vec3& x) {
    const StepId a = direction(axis), b = direction(x);
    return step_.add("AXIS2_PLACEMENT_3D('',", origin, ",", a, ",", b, ")");
  }

  Vertex make_vertex(const Vec3& p) {
    const StepId place = point(p);
    return {place, step_.add("VERTEX_POINT('',", place, ")")};
  }

  const Vertex& vertex(int i) {
    if (vertex_[i].vertex == StepId{}) vertex_[i] = make_vertex(body_.points[i]);
    return vertex_[i];
  }

  StepId edge_curve(StepId from, StepId to, StepId curve) {
    return step_.add("EDGE_CURVE('',", from, ",", to, ",", curve, ",.T.)");
  }

  StepId line_edge(const Vertex& from, const Vertex& to, const Vec3& d) {
    const StepId along = vector(d.normalized());
    return edge_curve(from.vertex, to.vertex, step_.add("LINE('',", from.point, ",", along, ")"));
  }

  StepId oriented(StepId edge, bool forward) {
    pending_.push_back(static_cast<int>(edge));
    return step_.add("ORIENTED_EDGE('',*,*,", edge, forward ? ",.T.)" : ",.F.)");
  }

  // The edge from point i to point j; it runs from the lower to the higher one.
  StepId oriented_edge(int i, int j) {
    const int a = std::min(i, j), b = std::max(i, j);
    StepId& id = edge_[static_cast<long long>(a) * body_.points.size() + b];
    if (id == StepId{}) {
      id = line_edge(vertex(a), vertex(b), body_.points[b] - body_.points[a]);
    }
    return oriented(id, i < j);
  }

  const Circle& make_circle(int i, const Vec3& axis) {
    const BodyCircle& c = body_.circles[i];
    Circle& circle = circle_[i];
    if (circle.edge != StepId{}) return circle;  // cap on a cylinder
    circle.axis = axis;
    circle.x = axis.unitOrthogonal();
    circle.start = make_vertex(c.centre + c.radius * circle.x);
    circle.edge = circle_edge(circle.start, circle.start, c.centre, axis, circle.x, c.radius);
    return circle;
  }

  StepId circle_edge(const Vertex& from, const Vertex& to, const Vec3& centre, const Vec3& axis,
                     const Vec3& x, double radius) {
    const StepId place = placement(point(centre), axis, x);
    return edge_curve(from.vertex, to.vertex, step_.add("CIRCLE('',", place, ",", radius, ")"));
  }

  StepId bound(const char* kind, const std::vector<StepId>& edges, bool forward) {
    const StepId loop = step_.add("EDGE_LOOP('',", edges, ")");
    return step_.add(kind, "('',", loop, forward ? ",.T.)" : ",.F.)");
  }

  void add_face(const std::vector<StepId>& bounds, StepId surface, bool forward) {
    faces_.push_back(
        step_.add("ADVANCED_FACE('',", bounds, ",", surface, forward ? ",.T.)" : ",.F.)"));
    for (int edge : pending_) faces_at_[edge].push_back(static_cast<int>(faces_.size()) - 1);
    edges_of_.push_back(std::move(pending_));
    pending_.clear();
  }

  // Breadth-first order, each face after one that shares an edge: OpenCASCADE's reader, which
  // builds shells face by face, takes minutes for a slab in any other order.
  std::vector<StepId> in_connected_order() const {
    std::vector<char> seen(faces_.size(), 0);
    std::vector<int> order;
    for (std::size_t start = 0; start < faces_.size(); ++start) {
      if (seen[start]) continue;
      seen[start] = 1;
      order.push_back(static_cast<int>(start));
      for (std::size_t at = order.size() - 1; at < order.size(); ++at) {
        for (int edge : edges_of_[order[at]]) {
          for (int face : faces_at_.at(edge)) {
            if (seen[face]) continue;
            seen[face] = 1;
            order.push_back(face);
          }
        }
      }
    }
    std::vector<StepId> out;
    for (int face : order) out.push_back(faces_[face]);
    return out;
  }

  StepId planar_bound(const PlanarFace& face, const BodyLoop& loop, bool outer) {
    std::vector<StepId> edges;
    if (loop.circle >= 0) {
      const Circle& circle = circle_[loop.circle];
      edges.push_back(oriented(circle.edge, (circle.axis.dot(face.normal) > 0) == outer));
    }
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      edges.push_back(oriented_edge(loop.points[k], loop.points[(k + 1) % loop.points.size()]));
    }
    return bound(outer ? "FACE_OUTER_BOUND" : "FACE_BOUND", edges, true);
  }

  void add_planar(const PlanarFace& face) {
    std::vector<StepId> bounds{planar_bound(face, face.outer, true)};
    for (const BodyLoop& loop : face.inner) bounds.push_back(planar_bound(face, loop, false));
    const StepId origin = face.outer.circle >= 0 ? circle_[face.outer.circle].start.point
                                                 : vertex(face.outer.points[0]).point;
    const StepId place = placement(origin, face.normal, face.normal.unitOrthogonal());
    add_face(bounds, step_.add("PLANE('',", place, ")"), true);
  }

  // Down the seam from the pole, once around, up again.
  void add_cap(const SphericalCap& cap) {
    const BodyCircle& c = body_.circles[cap.circle];
    const Circle& base = make_circle(cap.circle, cap.axis);
    const double R = sphere_radius(c.radius, cap.height);
    const Vec3 centre = c.centre - (R - cap.height) * cap.axis;
    const Vertex pole = make_vertex(c.centre + cap.height * cap.axis);
    const StepId seam = circle_edge(base.start, pole, centre, base.x.cross(cap.axis), base.x, R);
    const std::vector<StepId> edges{oriented(seam, false), oriented(base.edge, true),
                                    oriented(seam, true)};
    const StepId place = placement(point(centre), cap.axis, base.x);
    const StepId sphere = step_.add("SPHERICAL_SURFACE('',", place, ",", R, ")");
    add_face({bound("FACE_BOUND", edges, cap.bump)}, sphere, cap.bump);
  }

  void add_cylinder(const CylinderWall& wall) {
    const BodyCircle& c = body_.circles[wall.bottom];
    const Vec3 rise = body_.circles[wall.top].centre - c.centre, up = rise.normalized();
    const Circle& bottom = make_circle(wall.bottom, up);
    const Circle& top = make_circle(wall.top, up);
    const StepId seam = line_edge(bottom.start, top.start, rise);
    const std::vector<StepId> edges{oriented(bottom.edge, true), oriented(seam, true),
                                    oriented(top.edge, false), oriented(seam, false)};
    const StepId place = placement(point(c.centre), up, bottom.x);
    const StepId cylinder = step_.add("CYLINDRICAL_SURFACE('',", place, ",", c.radius, ")");
    add_face({bound("FACE_BOUND", edges, wall.outward)}, cylinder, wall.outward);
  }

  StepText& step_;
  const PrintBody& body_;
  std::vector<Vertex> vertex_;
  std::unordered_map<long long, StepId> edge_;
  std::vector<Circle> circle_;
  std::map<std::array<long long, 3>, StepId> direction_;
  std::unordered_map<int, StepId> vector_;  // along each direction
  std::vector<StepId> faces_;
  std::vector<int> pending_;                            // edges of the face to come
  std::vector<std::vector<int>> edges_of_;              // of each face
  std::unordered_map<int, std::vector<int>> faces_at_;  // of each edge
};

}  // namespace

StepId add_step_solid(StepText& step, const PrintBody& body) {
  return SolidWriter(step, body).run();
}

}  // namespace curveups
