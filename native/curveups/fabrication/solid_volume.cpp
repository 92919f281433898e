// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/solid_volume.hpp"

#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double same_parameter = 1e-12;  // radians, or mm along a cylinder

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

// A surface of revolution all the way around, between two heights (v, of its parameters).
struct Belt {
  double low, high;
};

// The part of its surface that a face is, where four edges go once around a rectangle of its
// parameters that is a full turn wide, and the way that leaves it to their left.
std::optional<Belt> belt_of(const TopoDS_Face& face) {
  const auto same = [](double a, double b) { return std::abs(a - b) <= same_parameter; };
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  std::vector<std::array<gp_Pnt2d, 2>> sides;
  for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double first, last;
    const Handle(Geom2d_Line) line =
        Handle(Geom2d_Line)::DownCast(BRep_Tool::CurveOnSurface(edge, forward, first, last));
    if (line.IsNull()) return std::nullopt;
    sides.push_back({line->Value(first), line->Value(last)});
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(sides.back()[0], sides.back()[1]);
  }
  if (sides.size() != 4) return std::nullopt;
  double left = sides[0][0].X(), right = left, low = sides[0][0].Y(), high = low;
  for (const auto& side : sides) {
    left = std::min(left, side[0].X());
    right = std::max(right, side[0].X());
    low = std::min(low, side[0].Y());
    high = std::max(high, side[0].Y());
  }
  const std::array<gp_Pnt2d, 4> corner = {gp_Pnt2d(left, low), gp_Pnt2d(right, low),
                                          gp_Pnt2d(right, high), gp_Pnt2d(left, high)};
  const auto meets = [&](const gp_Pnt2d& a, const gp_Pnt2d& b) {
    return same(a.X(), b.X()) && same(a.Y(), b.Y());
  };
  for (int k = 0; k < 4; ++k) {
    const bool there = std::any_of(sides.begin(), sides.end(), [&](const auto& side) {
      return meets(side[0], corner[k]) && meets(side[1], corner[(k + 1) % 4]);
    });
    if (!there) return std::nullopt;
  }
  if (!same(right - left, 2 * pi) || !(low < high)) return std::nullopt;
  return Belt{low, high};
}

// What a whole belt of a sphere or a cylinder spans with the apex: a third of the integral of
// (p - apex) n, where p = centre + radius n and the n of a belt sum up to a vector along the axis.
std::optional<double> belt_cone(const TopoDS_Face& face, const gp_Pnt& apex) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface);
  const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface);
  if (sphere.IsNull() && cylinder.IsNull()) return std::nullopt;
  const std::optional<Belt> belt = belt_of(face);
  if (!belt) return std::nullopt;
  double cone;
  gp_Ax3 place;
  if (!sphere.IsNull()) {
    place = sphere->Position();
    const double r = sphere->Radius(), low = std::sin(belt->low), high = std::sin(belt->high);
    const double along = (place.Location().XYZ() - apex.XYZ()).Dot(place.Direction().XYZ());
    cone = pi * r * r * ((high * high - low * low) * along + 2 * r * (high - low)) / 3;
  } else {
    place = cylinder->Position();
    const double r = cylinder->Radius();
    cone = 2 * pi * r * r * (belt->high - belt->low) / 3;
  }
  const bool inward = (face.Orientation() == TopAbs_REVERSED) == place.Direct();
  return inward ? -cone : cone;
}

double integrated_cone(const TopoDS_Face& found, const gp_Pnt& apex) {
  BRepGProp_Face face(found);
  BRepGProp_Domain domain(found);
  return BRepGProp_Vinert(face, domain, apex).Mass();
}

}  // namespace

double solid_volume(const TopoDS_Shape& shape) {
  const TopExp_Explorer corner(shape, TopAbs_VERTEX);
  if (!corner.More()) return 0;
  const gp_Pnt apex = BRep_Tool::Pnt(TopoDS::Vertex(corner.Current()));
  double volume = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    checkpoint();
    const TopoDS_Face face = TopoDS::Face(it.Current());
    std::optional<double> cone = plane_cone(face, apex);
    if (!cone) cone = belt_cone(face, apex);
    volume += cone ? *cone : integrated_cone(face, apex);
  }
  return volume;
}

}  // namespace curveups
