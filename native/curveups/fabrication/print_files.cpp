// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_files.hpp"

#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/fabrication/mesh_files.hpp"
#include "curveups/fabrication/step_file.hpp"
#include "curveups/fabrication/supports.hpp"
#include "curveups/geometry/unite_meshes.hpp"

namespace curveups {
namespace {

// Of each piece one shell: breakaway bridges reach into tiles and anchors.
std::vector<BodyMesh> fused(const std::vector<BodyMesh>& bodies, const PrintModel& model) {
  checkpoint("uniting bodies");
  if (support_kind(model.parameters).soluble) {
    throw InvalidInput("tiles and a soluble slab are of two materials, which can't be one shell",
                       "set support to breakaway");
  }
  std::vector<BodyMesh> out;
  for (int piece = 0; piece < model.piece_count; ++piece) {
    std::vector<TriangleMesh> solids;
    for (const BodyMesh& body : bodies) {
      if (body.piece != piece) continue;
      TriangleMesh solid{Points3(body.points.size(), 3), Triangles(body.triangles.size(), 3)};
      for (Eigen::Index v = 0; v < solid.V.rows(); ++v) solid.V.row(v) = body.points[v];
      for (Eigen::Index f = 0; f < solid.F.rows(); ++f) {
        for (int t = 0; t < 3; ++t) solid.F(f, t) = body.triangles[f][t];
      }
      solids.push_back(std::move(solid));
    }
    const TriangleMesh united = unite_meshes(solids);
    BodyMesh shell{model.name, BodyKind::tile, piece, {}, {}};
    for (Eigen::Index v = 0; v < united.V.rows(); ++v) shell.points.push_back(united.V.row(v));
    for (Eigen::Index f = 0; f < united.F.rows(); ++f) {
      shell.triangles.push_back({united.F(f, 0), united.F(f, 1), united.F(f, 2)});
    }
    out.push_back(std::move(shell));
  }
  return out;
}

std::vector<BodyMesh> meshes_of(const PrintModel& model, const std::string& kind) {
  const MeshingOptions options{model.parameters.mesh_deviation, true};
  if (kind == "fused") {
    return fused(mesh_bodies(model.bodies("print"), options), model);
  }
  return mesh_bodies(model.bodies(kind), options);
}

}  // namespace

void write_step(const PrintModel& model, const std::string& kind, const std::string& path) {
  write_step(model.bodies(kind), model.name + "-" + kind, path);
}

void write_stl(const PrintModel& model, const std::string& kind, const std::string& path) {
  write_stl(meshes_of(model, kind), model.name + "-" + kind, path);
}

void write_3mf(const PrintModel& model, const std::string& kind, const std::string& path) {
  write_3mf(meshes_of(model, kind), model.name,
            {"tiles (rigid)", support_kind(model.parameters).material, "anchors (rigid)"}, path);
}

const std::vector<PrintFormat>& print_formats() {
  static const std::vector<PrintFormat> formats = {
      {"step", {"tiles", "support", "anchors", "print", "actuated"}, {"print"}, write_step},
      {"stl", {"tiles", "support", "anchors"}, {"tiles", "support", "anchors"}, write_stl},
      {"3mf", {"print"}, {"print"}, write_3mf},
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
