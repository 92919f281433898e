// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_files.hpp"

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/mesh_files.hpp"
#include "curveups/fabrication/step_file.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups {
namespace {

std::vector<BodyMesh> meshes_of(const PrintModel& model, const std::string& kind,
                                const Progress& progress) {
  const MeshingOptions options{model.parameters.mesh_deviation, model.parameters.mesh_bumps};
  return mesh_bodies(model.bodies(kind), options, progress);
}

}  // namespace

void write_step(const PrintModel& model, const std::string& kind, const std::string& path,
                const Progress& progress) {
  const StepStructure structure = model.parameters.step_structure == "one-part"
                                      ? StepStructure::one_part
                                      : StepStructure::assembly;
  write_step(model.bodies(kind), model.name + "-" + kind, structure, path, progress);
}

void write_stl(const PrintModel& model, const std::string& kind, const std::string& path,
               const Progress& progress) {
  write_stl(meshes_of(model, kind, progress), model.name + "-" + kind, path);
}

void write_3mf(const PrintModel& model, const std::string& path, const Progress& progress) {
  const PrintMaterials materials{"tiles (rigid)", support_kind(model.parameters).material,
                                 "anchors (rigid)"};
  write_3mf(meshes_of(model, "print", progress), model.name, materials, path, progress);
}

const std::vector<PrintFormat>& print_formats() {
  static const std::vector<PrintFormat> formats = {
      {"step", {"tiles", "support", "anchors", "print", "actuated"}, {"print"}, write_step},
      {"stl", {"tiles", "support", "anchors"}, {"tiles", "support", "anchors"}, write_stl},
      {"3mf",
       {"print"},
       {"print"},
       [](const PrintModel& model, const std::string&, const std::string& path,
          const Progress& progress) { write_3mf(model, path, progress); }},
  };
  return formats;
}

const PrintFormat& print_format(const std::string& ending) {
  for (const PrintFormat& format : print_formats()) {
    if (format.ending == ending) return format;
  }
  throw InvalidInput("no print file is called ." + ending, "give step, stl or 3mf");
}

}  // namespace curveups
