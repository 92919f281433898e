// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_files.hpp"

#include <fmt/compile.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/fabrication/file_formats.hpp"
#include "curveups/fabrication/supports.hpp"
#include "curveups/geometry/unite_meshes.hpp"

namespace curveups {
namespace {

// Bridges, or all other bodies, of a piece in one mesh.
TriangleMesh joined(const std::vector<BodyMesh>& bodies, int piece, bool bridges) {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  for (const BodyMesh& body : bodies) {
    if (body.piece != piece || (body.kind == BodyKind::support) != bridges) continue;
    const int first = static_cast<int>(points.size());
    points.insert(points.end(), body.points.begin(), body.points.end());
    for (const auto& [a, b, c] : body.triangles) {
      triangles.push_back({a + first, b + first, c + first});
    }
  }
  TriangleMesh mesh{Points3(points.size(), 3), Triangles(triangles.size(), 3)};
  for (std::size_t v = 0; v < points.size(); ++v) mesh.V.row(v) = points[v];
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    mesh.F.row(f) << triangles[f][0], triangles[f][1], triangles[f][2];
  }
  return mesh;
}

// Closed shell of each piece: breakaway bridges reach into tiles and anchors.
std::vector<BodyMesh> fused(const std::vector<BodyMesh>& bodies, const PrintModel& model) {
  checkpoint("uniting bodies");
  if (support_kind(model.parameters).soluble) {
    throw InvalidInput("tiles and a soluble slab are of two materials, which can't be one shell",
                       "set support to breakaway");
  }
  std::vector<BodyMesh> shells;
  for (int piece = 0; piece < model.piece_count; ++piece) {
    const TriangleMesh united =
        unite_meshes(joined(bodies, piece, false), joined(bodies, piece, true));
    BodyMesh& shell = shells.emplace_back(BodyMesh{model.name, BodyKind::tile, piece, {}, {}});
    for (const auto p : united.V.rowwise()) shell.points.emplace_back(p);
    for (const auto f : united.F.rowwise()) shell.triangles.push_back({f[0], f[1], f[2]});
  }
  return shells;
}

std::vector<BodyMesh> meshes_of(const PrintModel& model, const std::string& kind) {
  const MeshingOptions options{model.parameters.mesh_deviation, true};
  if (kind == "fused") {
    return fused(mesh_bodies(model.bodies("print"), options), model);
  }
  return mesh_bodies(model.bodies(kind), options);
}

}  // namespace

OutputFile::OutputFile(const std::string& path)
    : path_(path), file_(path, std::ios::binary), opened_(file_.is_open()) {
  note_failure();
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (complete_ || !opened_ || !std::filesystem::is_regular_file(path_, ignored)) return;
  std::filesystem::remove(path_, ignored);
}

void OutputFile::write(const std::string& bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  note_failure();
}

void OutputFile::close() {
  if (opened_) file_.close();
  note_failure();
  complete_ = failure_ == 0;
  if (complete_) return;
  throw IoError("can't write " + path_ + ": " + std::strerror(failure_),
                "check that the folder exists, is writable and that the disk has room");
}

void OutputFile::note_failure() {
  if (!file_ && failure_ == 0) failure_ = errno;
}

void write_bytes(const std::string& path, const std::string& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.close();
}

void append_real(std::string& text, double value) {
  if (!std::isfinite(value)) {
    throw SolverFailure("a coordinate of a solid is not finite",
                        "report this with the design file");
  }
  char digits[40];
  text.append(digits, fmt::format_to(digits, FMT_COMPILE("{}"), value));
}

void write_step(const PrintModel& model, const std::string& kind, const std::string& path,
                const Title& title) {
  write_step(model.bodies(kind), title.value_or(model.name) + "-" + kind, path);
}

void write_stl(const PrintModel& model, const std::string& kind, const std::string& path,
               const Title& title) {
  write_stl(meshes_of(model, kind), title.value_or(model.name) + "-" + kind, path);
}

void write_3mf(const PrintModel& model, const std::string& kind, const std::string& path,
               const Title& title) {
  write_3mf(meshes_of(model, kind), title.value_or(model.name),
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
