// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/fabrication/occ_solids.hpp"
#include "curveups/fabrication/print_solids.hpp"

namespace curveups {
namespace {

constexpr double volume_tolerance = 1e-9;  // relative
constexpr std::size_t most_named = 3;      // unsound solids in a sentence

// Faces checked at a time: BRepCheck keeps some 20 kB a face, and a slab has thousands.
constexpr std::size_t faces_at_once = 256;

bool passes_brepcheck(const TopoDS_Shape& solid) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  if (faces.size() <= faces_at_once) return BRepCheck_Analyzer(solid).IsValid();
  for (std::size_t first = 0; first < faces.size(); first += faces_at_once) {
    checkpoint();
    const auto begin = faces.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(faces_at_once, faces.size() - first);
    if (!BRepCheck_Analyzer(make_compound({begin, begin + static_cast<std::ptrdiff_t>(count)}))
             .IsValid()) {
      return false;
    }
  }
  return true;
}

// Why a solid is unsound; empty where it is sound. volume: of its body, mm3.
std::string unsoundness(const TopoDS_Shape& solid, double volume) {
  if (!passes_brepcheck(solid)) return "invalid";
  for (TopExp_Explorer it(solid, TopAbs_SHELL); it.More(); it.Next()) {
    BRepCheck_Shell shell(TopoDS::Shell(it.Current()));
    checkpoint();
    if (shell.Closed() != BRepCheck_NoError) return "open";
    checkpoint();
    if (shell.Orientation() != BRepCheck_NoError) return "faces turned over";
  }
  if (!(volume > 0)) return "no volume";
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  return std::abs(properties.Mass() - volume) > volume_tolerance * volume ? "volume" : "";
}

}  // namespace

std::vector<UnsoundSolid> check_solids(const std::vector<const PrintBody*>& bodies,
                                       const std::vector<TopoDS_Shape>& solids) {
  // The largest first: a slab last would leave threads without work.
  std::vector<int> order(bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return bodies[a]->faces.size() > bodies[b]->faces.size(); });
  std::vector<std::string> reasons(solids.size());
  checkpoint("checking solids", 0);
  parallel_each(static_cast<int>(solids.size()), [&](int k) {
    const int i = order[k];
    reasons[i] = with_occ_errors("checking " + bodies[i]->name,
                                 [&] { return unsoundness(solids[i], volume(*bodies[i])); });
  });
  std::vector<UnsoundSolid> out;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (!reasons[i].empty()) out.push_back({bodies[i]->name, reasons[i], bodies[i]->tile});
  }
  return out;
}

std::vector<Finding> solid_reasons(const std::vector<UnsoundSolid>& unsound) {
  if (unsound.empty()) return {};
  Finding finding = {"unsound"};
  std::vector<Finding> named;
  for (const UnsoundSolid& solid : unsound) {
    if (solid.tile >= 0) finding.tiles.push_back(solid.tile);
    if (named.size() == most_named) continue;
    named.push_back({"unsound.solid", {}, {{"body", solid.body}, {"why", solid.reason}}});
  }
  std::sort(finding.tiles.begin(), finding.tiles.end());
  const int more = static_cast<int>(unsound.size() - named.size());
  finding.figures["solids"] = std::move(named);
  if (more > 0) {
    finding.kind = "unsound.many";
    finding.figures["more"] = more;
  }
  return {finding};
}

}  // namespace curveups
