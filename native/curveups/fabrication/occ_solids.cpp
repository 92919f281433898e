// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/occ_solids.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <gp_Sphere.hxx>
#include <unordered_map>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

gp_Pnt point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
gp_Dir direction(const Vec3& d) { return {d.x(), d.y(), d.z()}; }

class SolidBuilder {
 public:
  explicit SolidBuilder(const PrintBody& body)
      : body_(body), vertex_(body.points.size()), circle_(body.circles.size()) {}

  TopoDS_Shape run() {
    builder_.MakeShell(shell_);
    // Curved faces first: planar faces take their circles, reversed.
    for (const SphericalCap& cap : body_.caps) add_cap(cap);
    for (const CylinderWall& wall : body_.cylinders) add_cylinder(wall);
    for (const PlanarFace& face : body_.faces) {
      checkpoint();  // a slab has tens of thousands
      add_planar(face);
    }
    shell_.Closed(true);
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    builder_.Add(solid, shell_);
    return solid;
  }

 private:
  const TopoDS_Vertex& vertex(int i) {
    if (vertex_[i].IsNull()) {
      builder_.MakeVertex(vertex_[i], point(body_.points[i]), Precision::Confusion());
    }
    return vertex_[i];
  }

  // Edge from point i to point j; it runs from the lower to the higher number.
  TopoDS_Edge edge(int i, int j) {
    const int a = std::min(i, j), b = std::max(i, j);
    TopoDS_Edge& line = edge_[static_cast<long long>(a) * body_.points.size() + b];
    if (line.IsNull()) {
      const Vec3 d = body_.points[b] - body_.points[a];
      const double length = d.norm();
      builder_.MakeEdge(line, new Geom_Line(point(body_.points[a]), direction(d)),
                        Precision::Confusion());
      builder_.Add(line, vertex(a).Oriented(TopAbs_FORWARD));
      builder_.Add(line, vertex(b).Oriented(TopAbs_REVERSED));
      builder_.Range(line, 0, length);
    }
    return TopoDS::Edge(line.Oriented(i < j ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  TopoDS_Wire wire(const BodyLoop& loop) {
    TopoDS_Wire out;
    builder_.MakeWire(out);
    if (loop.circle >= 0) {
      builder_.Add(out, circle_[loop.circle]);
    } else {
      const std::size_t n = loop.points.size();
      for (std::size_t k = 0; k < n; ++k) {
        builder_.Add(out, edge(loop.points[k], loop.points[(k + 1) % n]));
      }
    }
    out.Closed(true);
    return out;
  }

  void add_planar(const PlanarFace& face) {
    const Vec3& origin = face.outer.circle >= 0 ? body_.circles[face.outer.circle].centre
                                                : body_.points[face.outer.points[0]];
    TopoDS_Face out;
    builder_.MakeFace(out, new Geom_Plane(point(origin), direction(face.normal)),
                      Precision::Confusion());
    builder_.Add(out, wire(face.outer));
    for (const BodyLoop& loop : face.inner) builder_.Add(out, wire(loop));
    builder_.Add(shell_, out);
  }

  // Circular edge of a curved face, which OpenCASCADE made.
  TopoDS_Edge find_circle(const TopoDS_Face& face, int circle) const {
    const BodyCircle& c = body_.circles[circle];
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      TopoDS_Edge e = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(e) || BRep_Tool::IsClosed(e, face)) continue;
      double first, last;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(e, first, last);
      const gp_Pnt a = curve->Value(first), b = curve->Value(0.5 * (first + last));
      const gp_Pnt middle((a.XYZ() + b.XYZ()) * 0.5);
      if (middle.Distance(point(c.centre)) <= 1e-6) return e;
    }
    throw SolverFailure("a circular edge of " + body_.name + " was not made",
                        "report this with the design file");
  }

  // Keeps a circle of a curved face, reversed, for the face that shares it.
  void keep_circle(const TopoDS_Face& face, int circle) {
    circle_[circle] = TopoDS::Edge(find_circle(face, circle).Reversed());
  }

  // Replaces the circle of a cylinder's face at this height by the circle of the cap above it.
  TopoDS_Face under_cap(const TopoDS_Face& face, int circle, double height) {
    const TopoDS_Shape own = find_circle(face, circle).Oriented(TopAbs_FORWARD);
    const TopoDS_Edge kept = TopoDS::Edge(circle_[circle].Oriented(TopAbs_FORWARD));
    builder_.UpdateEdge(kept, new Geom2d_Line({0, height}, {1, 0}), face, Precision::Confusion());
    const Handle(BRepTools_ReShape) shared = new BRepTools_ReShape;
    shared->Replace(TopExp::FirstVertex(TopoDS::Edge(own)), TopExp::FirstVertex(kept));
    shared->Replace(own, kept);
    return TopoDS::Face(shared->Apply(face));
  }

  void add_curved(TopoDS_Face face, bool forward) {
    if (!forward) face.Reverse();
    added_ = face;
    builder_.Add(shell_, face);
  }

  void add_cap(const SphericalCap& cap) {
    const BodyCircle& c = body_.circles[cap.circle];
    const double R = sphere_radius(c.radius, cap.height);
    const Vec3 centre = c.centre - (R - cap.height) * cap.axis;
    const gp_Sphere sphere(gp_Ax3(point(centre), direction(cap.axis)), R);
    const double base = std::asin(std::min(1.0, (R - cap.height) / R));
    add_curved(BRepBuilderAPI_MakeFace(sphere, 0, 2 * M_PI, base, 0.5 * M_PI).Face(), cap.bump);
    keep_circle(added_, cap.circle);
  }

  void add_cylinder(const CylinderWall& wall) {
    const BodyCircle& bottom = body_.circles[wall.bottom];
    const Vec3 up = body_.circles[wall.top].centre - bottom.centre;
    const gp_Cylinder cylinder(gp_Ax3(point(bottom.centre), direction(up)), bottom.radius);
    TopoDS_Face face = BRepBuilderAPI_MakeFace(cylinder, 0, 2 * M_PI, 0, up.norm()).Face();
    const bool capped = !circle_[wall.top].IsNull();
    if (capped) face = under_cap(face, wall.top, up.norm());
    add_curved(face, wall.outward);
    keep_circle(added_, wall.bottom);
    if (!capped) keep_circle(added_, wall.top);
  }

  const PrintBody& body_;
  BRep_Builder builder_;
  TopoDS_Shell shell_;
  TopoDS_Face added_;
  std::vector<TopoDS_Vertex> vertex_;
  std::unordered_map<long long, TopoDS_Edge> edge_;
  std::vector<TopoDS_Edge> circle_;  // as the planar face uses it
};

}  // namespace

TopoDS_Shape make_solid(const PrintBody& body) {
  return with_occ_errors("building " + body.name, [&] { return SolidBuilder(body).run(); });
}

std::vector<TopoDS_Shape> make_solids(const std::vector<const PrintBody*>& bodies) {
  std::vector<TopoDS_Shape> solids(bodies.size());
  checkpoint("building solids", 0);
  parallel_each(static_cast<int>(bodies.size()),
                [&](int i) { solids[i] = make_solid(*bodies[i]); });
  return solids;
}

TopoDS_Shape make_compound(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

}  // namespace curveups
