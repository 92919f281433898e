// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/occ_solids.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
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
#include <optional>
#include <unordered_map>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/fabrication/occ_errors.hpp"

namespace curveups {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double volume_tolerance = 1e-9;  // relative
constexpr int chunk = 32;                  // bodies between two calls of the progress sink

gp_Pnt point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
gp_Dir direction(const Vec3& d) { return {d.x(), d.y(), d.z()}; }

class SolidBuilder {
 public:
  explicit SolidBuilder(const PrintBody& body)
      : body_(body), vertex_(body.points.size()), circle_(body.circles.size()) {}

  TopoDS_Shape run() {
    builder_.MakeShell(shell_);
    // Curved faces first: their circles go, reversed, into the planar faces.
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

  // The edge from point i to point j, forward from the lower to the higher one.
  TopoDS_Edge edge(int i, int j) {
    const int a = std::min(i, j), b = std::max(i, j);
    TopoDS_Edge& made = edge_[static_cast<long long>(a) * body_.points.size() + b];
    if (made.IsNull()) {
      const Vec3 d = body_.points[b] - body_.points[a];
      const double length = d.norm();
      builder_.MakeEdge(made, new Geom_Line(point(body_.points[a]), direction(d)),
                        Precision::Confusion());
      builder_.Add(made, vertex(a).Oriented(TopAbs_FORWARD));
      builder_.Add(made, vertex(b).Oriented(TopAbs_REVERSED));
      builder_.Range(made, 0, length);
    }
    return TopoDS::Edge(made.Oriented(i < j ? TopAbs_FORWARD : TopAbs_REVERSED));
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

  // Keeps the circle at `centre` of a curved face for the planar face that shares it, where it has
  // the opposite orientation.
  void keep_circle(const TopoDS_Face& face, int circle) {
    const BodyCircle& c = body_.circles[circle];
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge e = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(e) || BRep_Tool::IsClosed(e, face)) continue;
      double first, last;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(e, first, last);
      const gp_Pnt a = curve->Value(first), b = curve->Value(0.5 * (first + last));
      const gp_Pnt middle((a.XYZ() + b.XYZ()) * 0.5);
      if (middle.Distance(point(c.centre)) > 1e-6) continue;
      circle_[circle] = TopoDS::Edge(e.Reversed());
      return;
    }
    throw SolverFailure("a circular edge of " + body_.name + " was not made",
                        "report this with the design file");
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
    add_curved(BRepBuilderAPI_MakeFace(sphere, 0, 2 * pi, base, 0.5 * pi).Face(), cap.bump);
    keep_circle(added_, cap.circle);
  }

  void add_cylinder(const CylinderWall& wall) {
    const BodyCircle& bottom = body_.circles[wall.bottom];
    const Vec3 up = body_.circles[wall.top].centre - bottom.centre;
    const gp_Cylinder cylinder(gp_Ax3(point(bottom.centre), direction(up)), bottom.radius);
    add_curved(BRepBuilderAPI_MakeFace(cylinder, 0, 2 * pi, 0, up.norm()).Face(), wall.outward);
    keep_circle(added_, wall.bottom);
    keep_circle(added_, wall.top);
  }

  const PrintBody& body_;
  BRep_Builder builder_;
  TopoDS_Shell shell_;
  TopoDS_Face added_;
  std::vector<TopoDS_Vertex> vertex_;
  std::unordered_map<long long, TopoDS_Edge> edge_;
  std::vector<TopoDS_Edge> circle_;  // as the planar face uses it
};

template <class Work>
void in_chunks(int count, const Progress& progress, const char* what, Work work) {
  for (int first = 0; first < count; first += chunk) {
    if (!keep_going(progress, what, static_cast<double>(first) / count)) throw Cancelled();
    parallel_ranges(std::min(chunk, count - first), [&](int begin, int end) {
      for (int i = first + begin; i < first + end; ++i) work(i);
    });
  }
}

}  // namespace

TopoDS_Shape make_solid(const PrintBody& body) {
  return with_occ_errors("building " + body.name, [&] { return SolidBuilder(body).run(); });
}

std::vector<TopoDS_Shape> make_solids(const std::vector<const PrintBody*>& bodies,
                                      const Progress& progress) {
  std::vector<TopoDS_Shape> solids(bodies.size());
  in_chunks(static_cast<int>(bodies.size()), progress, "building solids",
            [&](int i) { solids[i] = make_solid(*bodies[i]); });
  return solids;
}

namespace {

// The integral of p x dp / 2 along an edge as its face passes it, from a point `apex`. Around a
// plane face these sum up to its area times its normal. Nothing where the curve is no line and no
// circle.
std::optional<gp_XYZ> area_share(const TopoDS_Edge& edge, const gp_Pnt& apex) {
  double first, last;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (curve.IsNull()) return std::nullopt;
  const gp_XYZ from = curve->Value(first).XYZ() - apex.XYZ();
  const gp_XYZ to = curve->Value(last).XYZ() - apex.XYZ();
  const Handle(Geom_Circle) circle = Handle(Geom_Circle)::DownCast(curve);
  gp_XYZ share;
  if (!circle.IsNull()) {
    const gp_XYZ centre = circle->Location().XYZ() - apex.XYZ();
    const double r = circle->Radius();
    share = centre.Crossed(to - from) + r * r * (last - first) * circle->Axis().Direction().XYZ();
  } else if (curve->IsKind(STANDARD_TYPE(Geom_Line))) {
    share = from.Crossed(to);
  } else {
    return std::nullopt;
  }
  return (edge.Orientation() == TopAbs_REVERSED ? -0.5 : 0.5) * share;
}

// What a plane face spans with the apex, by the curves of its edges; nothing where it is curved.
std::optional<double> plane_cone(const TopoDS_Face& face, const gp_Pnt& apex) {
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face));
  if (plane.IsNull()) return std::nullopt;
  gp_XYZ area(0, 0, 0);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const std::optional<gp_XYZ> share = area_share(TopoDS::Edge(it.Current()), apex);
    if (!share) return std::nullopt;
    area += *share;
  }
  return (plane->Location().XYZ() - apex.XYZ()).Dot(area) / 3;
}

}  // namespace

double solid_volume(const TopoDS_Shape& shape) {
  // As BRepGProp::VolumeProperties has it, face by face: a slab has thousands. Those of plane faces
  // are sums over their edges, where BRepGProp integrates numerically.
  const TopExp_Explorer corner(shape, TopAbs_VERTEX);
  if (!corner.More()) return 0;
  const gp_Pnt apex = BRep_Tool::Pnt(TopoDS::Vertex(corner.Current()));
  double volume = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    checkpoint();
    const TopoDS_Face found = TopoDS::Face(it.Current());
    if (const std::optional<double> cone = plane_cone(found, apex)) {
      volume += *cone;
      continue;
    }
    BRepGProp_Face face(found);
    BRepGProp_Domain domain(found);
    volume += BRepGProp_Vinert(face, domain, apex).Mass();
  }
  return volume;
}

namespace {

// Solids of more faces are checked so many at a time: a slab is as much work as all tiles, which
// threads share, and BRepCheck keeps some 20 kB a face until it is done.
constexpr int faces_at_once = 256;

// What BRepCheck looks at in one go, and the body that it belongs to.
struct CheckPart {
  int body;
  TopoDS_Shape shape;
};

std::vector<CheckPart> check_parts(const std::vector<TopoDS_Shape>& solids) {
  std::vector<CheckPart> parts;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const int body = static_cast<int>(i);
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(solids[i], TopAbs_FACE); it.More(); it.Next()) {
      faces.push_back(it.Current());
    }
    if (faces.size() <= faces_at_once) {
      parts.push_back({body, solids[i]});
      continue;
    }
    for (std::size_t first = 0; first < faces.size(); first += faces_at_once) {
      const auto begin = faces.begin() + first;
      const auto end = faces.begin() + std::min(faces.size(), first + faces_at_once);
      parts.push_back({body, make_compound({begin, end})});
    }
  }
  return parts;
}

std::string closed_and_of_volume(const TopoDS_Shape& solid, double exact) {
  for (TopExp_Explorer it(solid, TopAbs_SHELL); it.More(); it.Next()) {
    BRepCheck_Shell shell(TopoDS::Shell(it.Current()));
    checkpoint();
    if (shell.Closed() != BRepCheck_NoError) return "open";
    checkpoint();
    if (shell.Orientation() != BRepCheck_NoError) return "faces turned over";
  }
  if (!(exact > 0)) return "no volume";
  return std::abs(solid_volume(solid) - exact) > volume_tolerance * exact ? "volume" : "";
}

}  // namespace

std::vector<UnsoundSolid> check_solids(const std::vector<const PrintBody*>& bodies,
                                       const std::vector<TopoDS_Shape>& solids,
                                       const Progress& progress) {
  const std::vector<CheckPart> parts = check_parts(solids);
  std::vector<char> broken(parts.size(), 0);
  in_chunks(static_cast<int>(parts.size()), progress, "checking solids", [&](int k) {
    broken[k] = with_occ_errors("checking " + bodies[parts[k].body]->name,
                                [&] { return !BRepCheck_Analyzer(parts[k].shape).IsValid(); });
  });
  std::vector<std::string> reason(solids.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (broken[k]) reason[parts[k].body] = "invalid";
  }
  in_chunks(static_cast<int>(solids.size()), progress, "measuring solids", [&](int i) {
    if (!reason[i].empty()) return;
    reason[i] = with_occ_errors("measuring " + bodies[i]->name, [&] {
      return closed_and_of_volume(solids[i], volume(*bodies[i]));
    });
  });
  std::vector<UnsoundSolid> out;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    if (!reason[i].empty()) out.push_back({bodies[i]->name, reason[i]});
  }
  return out;
}

TopoDS_Shape make_compound(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

}  // namespace curveups
