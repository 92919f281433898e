// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/plane_curves.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>

namespace curveups {
namespace {

class Copier {
 public:
  // Parts that several have in common are so in the copy.
  TopoDS_Shape copy(const TopoDS_Shape& shape) {
    const TopoDS_Shape key = shape.Located(TopLoc_Location());
    if (const TopoDS_Shape* made = made_.Seek(key)) return placed(*made, shape);
    TopoDS_Shape out = key.Oriented(TopAbs_FORWARD).EmptyCopied();
    for (TopoDS_Iterator it(key, false, false); it.More(); it.Next()) {
      builder_.Add(out, copy(it.Value()));
    }
    out.Closed(shape.Closed());
    if (out.ShapeType() == TopAbs_FACE) add_curves(TopoDS::Face(out));
    made_.Bind(key, out);
    return placed(out, shape);
  }

 private:
  static TopoDS_Shape placed(const TopoDS_Shape& made, const TopoDS_Shape& as) {
    return made.Located(as.Location()).Oriented(as.Orientation());
  }

  // Nothing where the surface is no plane.
  void add_curves(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      try {
        double first, last;
        const Handle(Geom2d_Curve) curve =
            BRep_Tool::CurveOnPlane(edge, surface, location, first, last);
        if (curve.IsNull()) continue;
        builder_.UpdateEdge(edge, curve, surface, location, BRep_Tool::Tolerance(edge));
      } catch (const Standard_Failure&) {
        // Without a curve BRepCheck projects the edge itself, and says what is wrong with it.
      }
    }
  }

  BRep_Builder builder_;
  TopTools_DataMapOfShapeShape made_;  // by shapes without their place, whichever way they face
};

}  // namespace

TopoDS_Shape with_plane_curves(const TopoDS_Shape& shape) { return Copier().copy(shape); }

}  // namespace curveups
