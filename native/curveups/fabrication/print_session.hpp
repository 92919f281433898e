// SPDX-License-Identifier: LGPL-2.1-or-later
// A print model with its solids, built once each, and its files: what the front end holds.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "curveups/bodies/clearance.hpp"
#include "curveups/fabrication/body_mesh.hpp"
#include "curveups/fabrication/occ_solids.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// Kinds of bodies: "tiles", "support", "anchors", "print" (all of them, in print coordinates) and
// "actuated" (the tiles in the target shape, without bumps). Any other throws InvalidInput.
class PrintSession {
 public:
  // Throws what make_print_model throws.
  PrintSession(const Design& design, const std::string& version);

  const PrintModel& model() const { return model_; }
  std::vector<const PrintBody*> bodies(const std::string& kind) const;
  // mm3, by the bodies' own formulas.
  double volume(const std::string& kind) const;

  // One compound of the kind's solids.
  TopoDS_Shape shape(const std::string& kind, const Progress& progress);
  // All bodies of the print.
  std::vector<UnsoundSolid> check(const Progress& progress);

  // Each writes under a temporary name and renames. Throw IoError, Cancelled.
  void write_step(const std::string& kind, const std::string& path, const Progress& progress) const;
  void write_stl(const std::string& kind, const std::string& path, const Progress& progress) const;
  void write_3mf(const std::string& path, const Progress& progress) const;

 private:
  const std::vector<TopoDS_Shape>& solids(const std::string& kind, const Progress& progress);
  std::vector<TopoDS_Shape> solids_of(const std::string& kind, const Progress& progress);
  MeshingOptions meshing() const;

  PrintModel model_;
  std::vector<PrintBody> actuated_;
  std::map<std::string, std::vector<TopoDS_Shape>> solids_;
};

}  // namespace curveups
