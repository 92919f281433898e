// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_session.hpp"

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/mesh_files.hpp"
#include "curveups/fabrication/step_file.hpp"

namespace curveups {
namespace {

// The kinds that bodies are kept in; "print" is all of them.
const std::vector<std::string> print_kinds = {"tiles", "support", "anchors"};

void append(const std::vector<PrintBody>& from, std::vector<const PrintBody*>& to) {
  for (const PrintBody& body : from) to.push_back(&body);
}

}  // namespace

PrintSession::PrintSession(const Design& design, const std::string& version)
    : model_(make_print_model(design, version)), actuated_(make_actuated_tiles(model_)) {}

std::vector<const PrintBody*> PrintSession::bodies(const std::string& kind) const {
  std::vector<const PrintBody*> out;
  if (kind == "tiles" || kind == "print") append(model_.tiles, out);
  if (kind == "support" || kind == "print") append(model_.supports, out);
  if (kind == "anchors" || kind == "print") append(model_.anchors, out);
  if (kind == "actuated") append(actuated_, out);
  if (out.empty() && kind != "support" && kind != "anchors") {
    throw InvalidInput("there are no bodies of the kind '" + kind + "'",
                       "give tiles, support, anchors, print or actuated");
  }
  return out;
}

double PrintSession::volume(const std::string& kind) const {
  double sum = 0;
  for (const PrintBody* body : bodies(kind)) sum += curveups::volume(*body);
  return sum;
}

const std::vector<TopoDS_Shape>& PrintSession::solids(const std::string& kind,
                                                      const Progress& progress) {
  const auto found = solids_.find(kind);
  if (found != solids_.end()) return found->second;
  return solids_[kind] = make_solids(bodies(kind), progress);
}

std::vector<TopoDS_Shape> PrintSession::solids_of(const std::string& kind,
                                                  const Progress& progress) {
  if (kind != "print") return solids(kind, progress);
  std::vector<TopoDS_Shape> all;
  for (const std::string& part : print_kinds) {
    const std::vector<TopoDS_Shape>& own = solids(part, progress);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

TopoDS_Shape PrintSession::shape(const std::string& kind, const Progress& progress) {
  return make_compound(solids_of(kind, progress));
}

std::vector<UnsoundSolid> PrintSession::check(const Progress& progress) {
  return check_solids(bodies("print"), solids_of("print", progress), progress);
}

void PrintSession::write_step(const std::string& kind, const std::string& path,
                              const Progress& progress) const {
  curveups::write_step(bodies(kind), model_.name + "-" + kind, path, progress);
}

MeshingOptions PrintSession::meshing() const {
  return {model_.parameters.mesh_deviation, model_.parameters.mesh_bumps};
}

void PrintSession::write_stl(const std::string& kind, const std::string& path,
                             const Progress& progress) const {
  curveups::write_stl(mesh_bodies(bodies(kind), meshing(), progress), model_.name + "-" + kind,
                      path);
}

void PrintSession::write_3mf(const std::string& path, const Progress& progress) const {
  curveups::write_3mf(mesh_bodies(bodies("print"), meshing(), progress), model_.name, path,
                      progress);
}

}  // namespace curveups
