// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "Model/COM/NMR_DLLInterfaces.h"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/fabrication/file_formats.hpp"

namespace curveups {
namespace {

// An object of lib3mf, released at the end of its scope.
template <class T>
class Held {
 public:
  Held() = default;
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  ~Held() {
    if (pointer_) NMR::lib3mf_release(pointer_);
  }
  T** out() { return &pointer_; }
  T* get() const { return pointer_; }

 private:
  T* pointer_ = nullptr;
};

// Throws SolverFailure for a negative HRESULT, which is a failure.
void require(long result) {
  if (static_cast<std::int32_t>(result) >= 0) return;
  char code[16];
  std::snprintf(code, sizeof code, "0x%08x", static_cast<unsigned>(result));
  throw SolverFailure(std::string("lib3mf could not write the print (") + code + ")",
                      "report this with the design file");
}

// Receives the archive from lib3mf. Writing to a buffer would need the size first, and so compress
// everything twice.
struct Archive {
  std::string bytes;
  std::size_t at = 0;

  static std::uint32_t write(std::uint8_t* data, std::uint32_t count, void* self) {
    Archive& archive = *static_cast<Archive*>(self);
    archive.bytes.resize(std::max(archive.bytes.size(), archive.at + count));
    std::copy(data, data + count, archive.bytes.begin() + archive.at);
    archive.at += count;
    return 0;
  }
  static std::uint32_t seek(std::uint64_t position, void* self) {
    static_cast<Archive*>(self)->at = position;
    return 0;
  }
};

// Progress callback: no exception may pass through lib3mf.
bool ask_to_go_on(int, NMR::ProgressIdentifier, void* cancelled) {
  try {
    checkpoint();
  } catch (const Cancelled&) {
    *static_cast<bool*>(cancelled) = true;
  }
  return !*static_cast<bool*>(cancelled);
}

// Replaces lib3mf's random numbers: the same meshes give the same bytes.
std::string uuid(unsigned kind, unsigned number) {
  char text[40];
  std::snprintf(text, sizeof text, "%08x-0000-4000-8000-%012x", kind, number);
  return text;
}

// Escapes text between tags; lib3mf does so for attributes alone.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    out += letter == '&'   ? "&amp;"
           : letter == '<' ? "&lt;"
           : letter == '>' ? "&gt;"
                           : std::string(1, letter);
  }
  return out;
}

// Little-endian numbers of a ZIP.
std::size_t number(const std::string& bytes, std::size_t at, int size) {
  std::size_t value = 0;
  for (int k = size; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes.at(at + k));
  return value;
}

void append(std::string& bytes, std::size_t value, int size) {
  for (int k = 0; k < size; ++k) bytes.push_back(static_cast<char>(value >> 8 * k));
}

// Turns lib3mf's archive, which is ZIP64 whatever its size and an empty scene to some readers, into
// a plain ZIP of the same compressed members, all dated 1980-01-01 00:00, the earliest date of ZIP.
std::string plain_zip(const std::string& zip) {
  constexpr std::size_t in_zip64 = 0xffffffff, most = 0xfffffffe;  // bytes
  if (zip.size() > most) {
    throw IoError("the 3MF would have more than 4 GB, which slicers do not read",
                  "raise mesh_deviation");
  }
  const std::size_t end = zip.rfind(std::string("PK\5\6", 4));
  if (end == std::string::npos) throw SolverFailure("lib3mf wrote no archive", "report this");
  std::size_t at = number(zip, end + 16, 4);
  if (at == in_zip64) at = number(zip, zip.rfind(std::string("PK\6\6", 4)) + 48, 8);
  const std::size_t entries = number(zip, end + 10, 2);
  std::string out, directory;
  for (std::size_t entry = 0; entry < entries; ++entry) {
    const std::size_t name_size = number(zip, at + 28, 2), extra_size = number(zip, at + 30, 2);
    const std::string name = zip.substr(at + 46, name_size);
    // Order of the ZIP64 field.
    std::size_t sizes[3] = {number(zip, at + 24, 4), number(zip, at + 20, 4),
                            number(zip, at + 42, 4)};
    std::size_t field = at + 46 + name_size + 4;
    for (std::size_t& size : sizes) {
      if (size != in_zip64) continue;
      size = number(zip, field, 8);
      field += 8;
    }
    const auto [whole, packed, local] = sizes;
    const std::size_t data = local + 30 + number(zip, local + 26, 2) + number(zip, local + 28, 2);
    std::string common;  // fields that both headers share
    append(common, 20, 2);
    append(common, 0, 2);
    common += zip.substr(at + 10, 2);  // method
    append(common, 0x00210000, 4);
    common += zip.substr(at + 16, 4);  // checksum
    append(common, packed, 4);
    append(common, whole, 4);
    append(common, name_size, 2);
    append(common, 0, 2);
    directory += "PK\1\2";
    append(directory, 20, 2);
    directory += common;
    append(directory, 0, 10);  // no comment, first disk, no attributes
    append(directory, out.size(), 4);
    directory += name;
    out += "PK\3\4";
    out += common;
    out += name;
    out.append(zip, data, packed);
    at += 46 + name_size + extra_size + number(zip, at + 32, 2);
  }
  const std::size_t begin = out.size();
  out += directory;
  out += "PK\5\6";
  append(out, 0, 4);
  append(out, entries, 2);
  append(out, entries, 2);
  append(out, directory.size(), 4);
  append(out, begin, 4);
  append(out, 0, 2);
  return out;
}

using Mesh = Held<NMR::PLib3MFModelMeshObject>;

// Adds one build item: the bodies of a piece where they are.
void place_piece(NMR::PLib3MFModel* model, const std::vector<std::unique_ptr<Mesh>>& bodies,
                 const std::string& name, int piece) {
  Held<NMR::PLib3MFModelComponentsObject> assembly;
  require(NMR::lib3mf_model_addcomponentsobject(model, assembly.out()));
  require(NMR::lib3mf_object_setnameutf8(assembly.get(), name.c_str()));
  require(NMR::lib3mf_object_setuuidutf8(assembly.get(), uuid(4, piece + 1).c_str()));
  unsigned number = 0;
  for (const auto& body : bodies) {
    Held<NMR::PLib3MFModelComponent> component;
    require(NMR::lib3mf_componentsobject_addcomponent(assembly.get(), body->get(), nullptr,
                                                      component.out()));
    const std::string id = uuid(0x100 + piece, ++number);
    require(NMR::lib3mf_component_setuuidutf8(component.get(), id.c_str()));
  }
  Held<NMR::PLib3MFModelBuildItem> item;
  require(NMR::lib3mf_model_addbuilditem(model, assembly.get(), nullptr, item.out()));
  require(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid(3, piece + 1).c_str()));
}

// Material of each BodyKind in one group.
struct Materials {
  Held<NMR::PLib3MFModelBaseMaterial> held;
  DWORD group = 0;
  std::array<DWORD, 3> id{};

  Materials(NMR::PLib3MFModel* model, const std::array<std::string, 3>& names) {
    require(NMR::lib3mf_model_addbasematerialgroup(model, held.out()));
    require(NMR::lib3mf_basematerial_getresourceid(held.get(), &group));
    for (int k = 0; k < 3; ++k) {
      const Colour c = body_colour(static_cast<BodyKind>(k));
      require(NMR::lib3mf_basematerial_addmaterialutf8(held.get(), names[k].c_str(), c.red, c.green,
                                                       c.blue, &id[k]));
      // Opaque: without this it would be transparent.
      require(NMR::lib3mf_basematerial_setdisplaycolorrgba(held.get(), id[k], c.red, c.green,
                                                           c.blue, 255));
    }
  }
};

void add_mesh(NMR::PLib3MFModel* model, const BodyMesh& mesh, const Materials& materials,
              unsigned number, Mesh& object) {
  std::vector<NMR::MODELMESHVERTEX> points(mesh.points.size());
  std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) points[i].m_fPosition[k] = static_cast<float>(mesh.points[i][k]);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) triangles[i].m_nIndices[k] = mesh.triangles[i][k];
  }
  require(NMR::lib3mf_model_addmeshobject(model, object.out()));
  require(NMR::lib3mf_object_setnameutf8(object.get(), mesh.name.c_str()));
  require(NMR::lib3mf_object_setuuidutf8(object.get(), uuid(2, number).c_str()));
  require(NMR::lib3mf_meshobject_setgeometry(object.get(), points.data(),
                                             static_cast<DWORD>(points.size()), triangles.data(),
                                             static_cast<DWORD>(triangles.size())));
  Held<NMR::PLib3MFDefaultPropertyHandler> property;
  require(NMR::lib3mf_object_createdefaultpropertyhandler(object.get(), property.out()));
  require(NMR::lib3mf_defaultpropertyhandler_setbasematerial(
      property.get(), materials.group, materials.id[static_cast<int>(mesh.kind)]));
}

}  // namespace

void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::array<std::string, 3>& names, const std::string& path) {
  Held<NMR::PLib3MFModel> model;
  require(NMR::lib3mf_createmodel(model.out()));
  require(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER));
  require(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid(1, 1).c_str()));
  require(NMR::lib3mf_model_addmetadatautf8(model.get(), "Title", escaped(title).c_str()));
  const Materials materials(model.get(), names);
  std::vector<std::vector<std::unique_ptr<Mesh>>> pieces;
  unsigned number = 0;
  for (const BodyMesh& mesh : meshes) {
    if (++number % 64 == 0) {
      checkpoint("writing 3MF", static_cast<double>(number) / meshes.size());
    }
    if (mesh.piece >= static_cast<int>(pieces.size())) pieces.resize(mesh.piece + 1);
    pieces[mesh.piece].push_back(std::make_unique<Mesh>());
    add_mesh(model.get(), mesh, materials, number, *pieces[mesh.piece].back());
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::string name = pieces.size() > 1 ? title + " P" + std::to_string(k + 1) : title;
    place_piece(model.get(), pieces[k], name, static_cast<int>(k));
  }
  Held<NMR::PLib3MFModelWriter> writer;
  require(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()));
  Archive archive;
  bool cancelled = false;
  require(NMR::lib3mf_writer_setprogresscallback(writer.get(), &ask_to_go_on, &cancelled));
  const long result =
      NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(&Archive::write),
                                         reinterpret_cast<void*>(&Archive::seek), &archive);
  if (cancelled) throw Cancelled();
  require(result);
  write_bytes(path, plain_zip(archive.bytes));
}

}  // namespace curveups
