// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/solid_checks.hpp"

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
#include "curveups/fabrication/occ_errors.hpp"
#include "curveups/fabrication/occ_solids.hpp"

namespace curveups {
namespace {

constexpr double volume_tolerance = 1e-9;  // relative

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

// Solids that are measured in one go each: a slab last would leave threads without work.
std::vector<int> largest_first(const std::vector<const PrintBody*>& bodies) {
  std::vector<int> order(bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return bodies[a]->faces.size() > bodies[b]->faces.size(); });
  return order;
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
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  return std::abs(properties.Mass() - exact) > volume_tolerance * exact ? "volume" : "";
}

}  // namespace

std::vector<UnsoundSolid> check_solids(const std::vector<const PrintBody*>& bodies,
                                       const std::vector<TopoDS_Shape>& solids) {
  const std::vector<CheckPart> parts = check_parts(solids);
  checkpoint("checking solids", 0);
  std::vector<char> broken(parts.size(), 0);
  parallel_each(static_cast<int>(parts.size()), [&](int k) {
    broken[k] = with_occ_errors("checking " + bodies[parts[k].body]->name,
                                [&] { return !BRepCheck_Analyzer(parts[k].shape).IsValid(); });
  });
  std::vector<std::string> reason(solids.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (broken[k]) reason[parts[k].body] = "invalid";
  }
  const std::vector<int> order = largest_first(bodies);
  checkpoint("measuring solids", 0);
  parallel_each(static_cast<int>(solids.size()), [&](int k) {
    const int i = order[k];
    if (!reason[i].empty()) return;
    reason[i] = with_occ_errors("measuring " + bodies[i]->name, [&] {
      return closed_and_of_volume(solids[i], volume(*bodies[i]));
    });
  });
  std::vector<UnsoundSolid> out;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    if (!reason[i].empty()) out.push_back({bodies[i]->name, reason[i], bodies[i]->tile});
  }
  return out;
}

}  // namespace curveups
