// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/brep_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <unordered_map>
#include <utility>

#include "curveups/core/parallel.hpp"
#include "curveups/fabrication/file_formats.hpp"

namespace curveups {
namespace {

constexpr double pi = 3.141592653589793;

void append(std::string& text, const char* words) { text += words; }
void append(std::string& text, double value) { append_real(text, value); }
void append(std::string& text, int value) {
  char digits[16];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}
void append(std::string& text, const Vec3& v) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) text += ' ';
    append_real(text, v[k]);
  }
}

// Appends parts with spaces between them, which OpenCASCADE skips like ends of lines.
template <class... Parts>
void append_line(std::string& text, const Parts&... parts) {
  ((append(text, parts), text += ' '), ...);
  text.back() = '\n';
}

// A list of curves or surfaces, numbered from 1. Each begins with the number of its type.
struct Section {
  const char* name;
  std::string text = {};
  int count = 0;

  template <class... Parts>
  int add(const Parts&... parts) {
    append_line(text, parts...);
    return ++count;
  }
};
constexpr int line_type = 1, circle_type = 2, plane_type = 1, cylinder_type = 2, sphere_type = 4;

// Number of a shape, from 1 in the order of writing; negative where it is used reversed.
using ShapeId = int;

// Flags: free, modified, checked, orientable, closed, infinite, convex.
constexpr const char *open = "0101000", *closed = "0101100", *of_vertex = "0101101";
constexpr const char* tolerance = "1e-07";  // Precision::Confusion

// Coordinate axis nearest to a direction. Readers take an axis and x of a frame, make x normal to
// the axis, and see on which side y is: few digits do for y, and for x of a plane.
Vec3 coarse(const Vec3& direction) {
  Eigen::Index k;
  direction.cwiseAbs().maxCoeff(&k);
  Vec3 axis = Vec3::Zero();
  axis[k] = direction[k] > 0 ? 1 : -1;
  return axis;
}

class SolidWriter {
 public:
  explicit SolidWriter(const PrintBody& body)
      : body_(body), vertex_(body.points.size()), circle_(body.circles.size()) {}

  std::string run() {
    // Surfaces first: edges carry curves on them, and they determine directions of circles.
    for (const SphericalCap& cap : body_.caps) add_sphere(cap);
    for (const CylinderWall& wall : body_.cylinders) add_cylinder(wall);
    for (std::size_t k = 0; k < circle_.size(); ++k) add_circle(static_cast<int>(k));
    int surface = 0;
    for (const SphericalCap& cap : body_.caps) add_cap(cap, ++surface);
    for (const CylinderWall& wall : body_.cylinders) add_wall(wall, ++surface);
    for (const PlanarFace& face : body_.faces) add_planar(face);
    shapes_ += "Sh\n";
    const ShapeId shell = end_shape(closed, faces_);
    shapes_ += "So\n";
    end_shape(open, {shell});
    return text();
  }

 private:
  // A whole circle, counter-clockwise about `axis` from its start on the side of x.
  struct Circle {
    Vec3 axis = Vec3::Zero(), x;
    std::string on_surfaces;  // curves of it there
    ShapeId start = 0, edge = 0;
  };

  Circle& circle(int i, const Vec3& axis) {
    Circle& circle = circle_[i];
    if (circle.axis.isZero()) {
      circle.axis = axis;
      circle.x = axis.unitOrthogonal();
    }
    return circle;
  }

  // Text of a curve (u, v) to (u + 2 pi, v) on a surface.
  void append_around(std::string& text, double v, int surface) {
    const int curve = curves2d_.add(line_type, 0.0, v, 1.0, 0.0);
    append_line(text, 2, curve, surface, 0, 0.0, 2 * pi);
    append_line(text, 0.0, v, 2 * pi, v);
  }

  // Adds a frame's surface and returns its number.
  int add_surface(int type, const Vec3& origin, const Vec3& axis, const Vec3& x, double radius) {
    return surfaces_.add(type, origin, axis, x, coarse(axis.cross(x)), radius);
  }

  void add_sphere(const SphericalCap& cap) {
    Circle& base = circle(cap.circle, cap.axis);
    const double R = sphere_radius(body_.circles[cap.circle].radius, cap.height);
    append_around(base.on_surfaces, latitude(cap, R),
                  add_surface(sphere_type, centre(cap, R), cap.axis, base.x, R));
  }

  void add_cylinder(const CylinderWall& wall) {
    const BodyCircle& c = body_.circles[wall.bottom];
    const Vec3 rise = body_.circles[wall.top].centre - c.centre, up = rise.normalized();
    Circle &bottom = circle(wall.bottom, up), &top = circle(wall.top, up);
    const int surface = add_surface(cylinder_type, c.centre, up, bottom.x, c.radius);
    append_around(bottom.on_surfaces, 0, surface);
    append_around(top.on_surfaces, rise.norm(), surface);
  }

  static double latitude(const SphericalCap& cap, double R) {
    return std::asin(std::min(1.0, (R - cap.height) / R));
  }
  Vec3 centre(const SphericalCap& cap, double R) const {
    return body_.circles[cap.circle].centre - (R - cap.height) * cap.axis;
  }

  // Ends the shape that shapes_ has the geometry of: its flags and its parts.
  template <class Parts>
  ShapeId end_shape(const char* flags, const Parts& parts) {
    shapes_ += '\n';
    append_line(shapes_, flags);
    parts_.insert(parts_.end(), parts.begin(), parts.end());
    ends_.emplace_back(shapes_.size(), parts_.size());
    return static_cast<ShapeId>(ends_.size());
  }
  ShapeId end_shape(const char* flags, std::initializer_list<ShapeId> parts) {
    return end_shape<std::initializer_list<ShapeId>>(flags, parts);
  }

  ShapeId add_vertex(const Vec3& p) {
    append_line(shapes_, "Ve\n", tolerance, "\n", p, "\n0 0\n");
    return end_shape(of_vertex, {});
  }

  ShapeId vertex(int i) {
    if (vertex_[i] == 0) vertex_[i] = add_vertex(body_.points[i]);
    return vertex_[i];
  }

  void begin_edge(bool degenerated = false) {
    append_line(shapes_, "Ed\n", tolerance, "1 1", degenerated ? 1 : 0);
  }
  ShapeId end_edge(ShapeId first, ShapeId last) {
    append_line(shapes_, 0);
    return end_shape(open, {first, -last});
  }

  void append_line_curve(const Vec3& from, const Vec3& rise) {
    const double length = rise.norm();
    append_line(shapes_, 1, curves_.add(line_type, from, Vec3(rise / length)), 0, 0.0, length);
  }
  void append_circle_curve(const Vec3& c, const Vec3& axis, const Vec3& x, double radius,
                           double first, double last) {
    const int curve = curves_.add(circle_type, c, axis, x, coarse(axis.cross(x)), radius);
    append_line(shapes_, 1, curve, 0, first, last);
  }
  // The two curves of a seam, which leaves the surface at u = 2 pi and comes back at u = 0.
  void append_seam_curves(int surface, double first, double last) {
    const int end = curves2d_.add(line_type, 2 * pi, 0.0, 0.0, 1.0);
    const int begin = curves2d_.add(line_type, 0.0, 0.0, 0.0, 1.0);
    append_line(shapes_, 3, end, begin, "C0", surface, 0, first, last);
    append_line(shapes_, 0.0, first, 0.0, last);
  }

  // Edge from point i to point j; it runs from the lower to the higher number.
  ShapeId edge(int i, int j) {
    const int a = std::min(i, j), b = std::max(i, j);
    ShapeId& line = edge_[static_cast<long long>(a) * body_.points.size() + b];
    if (line == 0) {
      const ShapeId first = vertex(a), last = vertex(b);
      begin_edge();
      append_line_curve(body_.points[a], body_.points[b] - body_.points[a]);
      line = end_edge(first, last);
    }
    return i < j ? line : -line;
  }

  void add_circle(int i) {
    const BodyCircle& c = body_.circles[i];
    Circle& round = circle(i, c.axis);
    round.start = add_vertex(c.centre + c.radius * round.x);
    begin_edge();
    append_circle_curve(c.centre, round.axis, round.x, c.radius, 0, 2 * pi);
    shapes_ += round.on_surfaces;
    round.edge = end_edge(round.start, round.start);
  }

  template <class Parts>
  ShapeId add_wire(const Parts& edges) {
    shapes_ += "Wi\n";
    return end_shape(closed, edges);
  }
  void add_face(int surface, const std::vector<ShapeId>& wires, bool forward) {
    append_line(shapes_, "Fa\n0", tolerance, surface, 0);
    const ShapeId face = end_shape(open, wires);
    faces_.push_back(forward ? face : -face);
  }

  void add_cap(const SphericalCap& cap, int surface) {
    const Circle& base = circle_[cap.circle];
    const double R = sphere_radius(body_.circles[cap.circle].radius, cap.height);
    const double v = latitude(cap, R);
    const ShapeId pole = add_vertex(body_.circles[cap.circle].centre + cap.height * cap.axis);
    begin_edge();
    append_circle_curve(centre(cap, R), base.x.cross(cap.axis), base.x, R, v, pi / 2);
    append_seam_curves(surface, v, pi / 2);
    const ShapeId seam = end_edge(base.start, pole);
    begin_edge(true);
    append_around(shapes_, pi / 2, surface);
    const ShapeId apex_edge = end_edge(pole, pole);
    add_face(surface, {add_wire(std::vector<ShapeId>{-seam, base.edge, seam, -apex_edge})},
             cap.bump);
  }

  void add_wall(const CylinderWall& wall, int surface) {
    const Circle &bottom = circle_[wall.bottom], &top = circle_[wall.top];
    const BodyCircle& c = body_.circles[wall.bottom];
    const Vec3 rise = body_.circles[wall.top].centre - c.centre;
    begin_edge();
    append_line_curve(c.centre + c.radius * bottom.x, rise);
    append_seam_curves(surface, 0, rise.norm());
    const ShapeId seam = end_edge(bottom.start, top.start);
    add_face(surface, {add_wire(std::vector<ShapeId>{bottom.edge, seam, -top.edge, -seam})},
             wall.outward);
  }

  ShapeId planar_wire(const PlanarFace& face, const BodyLoop& loop, bool outer) {
    std::vector<ShapeId> edges;
    if (loop.circle >= 0) {
      const Circle& round = circle_[loop.circle];
      const bool forward = (round.axis.dot(face.normal) > 0) == outer;
      edges.push_back(forward ? round.edge : -round.edge);
    }
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      edges.push_back(edge(loop.points[k], loop.points[(k + 1) % loop.points.size()]));
    }
    return add_wire(edges);
  }

  void add_planar(const PlanarFace& face) {
    std::vector<ShapeId> wires{planar_wire(face, face.outer, true)};
    for (const BodyLoop& loop : face.inner) wires.push_back(planar_wire(face, loop, false));
    const Vec3& origin = face.outer.circle >= 0 ? body_.circles[face.outer.circle].centre
                                                : body_.points[face.outer.points[0]];
    const Vec3 x = coarse(face.normal.unitOrthogonal()), y = coarse(face.normal.cross(x));
    add_face(surfaces_.add(plane_type, origin, face.normal, x, y), wires, true);
  }

  std::string text() const {
    std::string out;
    out.reserve(curves2d_.text.size() + curves_.text.size() + surfaces_.text.size() +
                shapes_.size() + 12 * parts_.size() + 200);
    out += "CASCADE Topology V2, (c) Matra-Datavision\nLocations 0\n";
    const auto append_section = [&](const Section& section) {
      append_line(out, section.name, section.count);
      out += section.text;
    };
    append_section(curves2d_);
    append_section(curves_);
    out += "Polygon3D 0\nPolygonOnTriangulations 0\n";
    append_section(surfaces_);
    const int count = static_cast<int>(ends_.size());
    append_line(out, "Triangulations 0\n\nTShapes", count);
    std::size_t at = 0, part = 0;
    for (const auto& [end, parts_end] : ends_) {
      out.append(shapes_, at, end - at);
      at = end;
      for (; part < parts_end; ++part) {
        out += parts_[part] > 0 ? '+' : '-';
        append_line(out, count + 1 - std::abs(parts_[part]), 0);  // counted from the last
      }
      out += "*\n";
    }
    return out += "\n+1 0\n";
  }

  const PrintBody& body_;
  Section curves2d_{"Curve2ds"}, curves_{"Curves"}, surfaces_{"Surfaces"};
  std::string shapes_;  // each but for its parts
  std::vector<ShapeId> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;  // ends of each shape and of its parts
  std::vector<ShapeId> vertex_, faces_;
  std::unordered_map<long long, ShapeId> edge_;
  std::vector<Circle> circle_;
};

}  // namespace

std::string brep_text(const PrintBody& body) { return SolidWriter(body).run(); }

std::vector<std::string> brep_texts(const std::vector<const PrintBody*>& bodies) {
  std::vector<std::string> texts(bodies.size());
  parallel_for(static_cast<int>(bodies.size()), [&](int i) { texts[i] = brep_text(*bodies[i]); });
  return texts;
}

}  // namespace curveups
