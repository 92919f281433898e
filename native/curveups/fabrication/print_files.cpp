// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_files.hpp"

#include "curveups/fabrication/mesh_files.hpp"
#include "curveups/fabrication/step_file.hpp"

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
  write_step(model.bodies(kind), model.name + "-" + kind, path, progress);
}

void write_stl(const PrintModel& model, const std::string& kind, const std::string& path,
               const Progress& progress) {
  write_stl(meshes_of(model, kind, progress), model.name + "-" + kind, path);
}

void write_3mf(const PrintModel& model, const std::string& path, const Progress& progress) {
  write_3mf(meshes_of(model, "print", progress), model.name, path, progress);
}

}  // namespace curveups
