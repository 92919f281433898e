// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_solids.hpp"

#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopoDS_Iterator.hxx>
#include <fstream>
#include <mutex>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/occ_solids.hpp"

namespace curveups {
namespace {

std::vector<TopoDS_Shape> parts_of(const TopoDS_Shape& compound) {
  std::vector<TopoDS_Shape> parts;
  for (TopoDS_Iterator it(compound); it.More(); it.Next()) parts.push_back(it.Value());
  return parts;
}

}  // namespace

std::shared_ptr<const TopoDS_Shape> solids_of(const PrintModel& model, const std::string& kind) {
  KeptSolids& kept = *model.solids;
  const std::lock_guard<std::recursive_mutex> lock(kept.building);
  std::shared_ptr<const TopoDS_Shape>& shape = kept.by_kind[kind];
  if (shape) return shape;
  std::vector<TopoDS_Shape> solids;
  if (kind == "print") {
    for (const char* part : {"tiles", "support", "anchors"}) {
      for (const TopoDS_Shape& solid : parts_of(*solids_of(model, part))) {
        solids.push_back(solid);
      }
    }
  } else {
    solids = make_solids(model.bodies(kind));
  }
  return shape = std::make_shared<TopoDS_Shape>(make_compound(solids));
}

void write_binary_brep(const TopoDS_Shape& shape, const std::string& path) {
  // The format: a set of shapes, then the number, place and orientation of this one.
  BinTools_ShapeSet set;
  const int number = set.Add(shape), place = set.Locations().Index(shape.Location()),
            orientation = static_cast<int>(shape.Orientation());
  std::ofstream out(path, std::ios::binary);
  with_occ_errors("writing shapes", [&] {
    set.Write(out);
    BinTools::PutInteger(out, number);
    BinTools::PutInteger(out, place);
    BinTools::PutInteger(out, orientation);
  });
  out.close();
  if (!out) throw IoError("a temporary file can't be written (" + path + ")", "free some space");
}

std::vector<UnsoundSolid> check_solids(const PrintModel& model) {
  return check_solids(model.bodies("print"), parts_of(*solids_of(model, "print")));
}

}  // namespace curveups
