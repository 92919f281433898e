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
#include "curveups/fabrication/mesh_files.hpp"
#include "curveups/fabrication/palette.hpp"
#include "curveups/fabrication/write_bytes.hpp"

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

// lib3mf answers with COM's HRESULT: negative is a failure.
void require(long result, const std::string& what) {
  if (static_cast<std::int32_t>(result) >= 0) return;
  char code[16];
  std::snprintf(code, sizeof code, "0x%08x", static_cast<unsigned>(result));
  throw SolverFailure("lib3mf could not " + what + " (" + code + ")",
                      "report this with the design file");
}

// Takes the archive as lib3mf writes it: asking for its size first, as writing to a buffer needs,
// would make it twice.
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

// lib3mf's frames lie between this and who asked for the file: it is told to end, and has no more
// to write to than it is used to.
bool ask_to_go_on(int, NMR::ProgressIdentifier, void* cancelled) {
  try {
    checkpoint();
  } catch (const Cancelled&) {
    *static_cast<bool*>(cancelled) = true;
  }
  return !*static_cast<bool*>(cancelled);
}

// lib3mf would draw random ones; files must be the same every time.
std::string uuid(unsigned kind, unsigned number) {
  char text[40];
  std::snprintf(text, sizeof text, "%08x-0000-4000-8000-%012x", kind, number);
  return text;
}

// Text between tags, which lib3mf writes as it is given (attributes it escapes).
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '&') {
      out += "&amp;";
    } else if (letter == '<') {
      out += "&lt;";
    } else if (letter == '>') {
      out += "&gt;";
    } else {
      out += letter;
    }
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

// lib3mf writes ZIP64 whatever the size, which some readers take for an empty scene. The same
// compressed members in a plain ZIP, all with the earliest date that ZIP knows, 1980-01-01 00:00:
// lib3mf writes none or the present time.
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
    // What is in the ZIP64 field stands there in this order.
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
    std::string common;  // of both headers
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

using Body = std::unique_ptr<Held<NMR::PLib3MFModelMeshObject>>;

// One build item: the bodies where they are.
void place_piece(NMR::PLib3MFModel* model, const std::vector<Body>& bodies,
                 const std::string& title, int piece, int piece_count) {
  const std::string name = piece_count > 1 ? title + " P" + std::to_string(piece + 1) : title;
  Held<NMR::PLib3MFModelComponentsObject> assembly;
  require(NMR::lib3mf_model_addcomponentsobject(model, assembly.out()), "add " + name);
  require(NMR::lib3mf_object_setnameutf8(assembly.get(), name.c_str()), "name " + name);
  require(NMR::lib3mf_object_setuuidutf8(assembly.get(), uuid(4, piece + 1).c_str()),
          "name " + name);
  unsigned number = 0;
  for (const Body& body : bodies) {
    Held<NMR::PLib3MFModelComponent> component;
    require(NMR::lib3mf_componentsobject_addcomponent(assembly.get(), body->get(), nullptr,
                                                      component.out()),
            "put a body into " + name);
    require(
        NMR::lib3mf_component_setuuidutf8(component.get(), uuid(0x100 + piece, ++number).c_str()),
        "name a body of " + name);
  }
  Held<NMR::PLib3MFModelBuildItem> item;
  require(NMR::lib3mf_model_addbuilditem(model, assembly.get(), nullptr, item.out()),
          "place " + name);
  require(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid(3, piece + 1).c_str()),
          "place " + name);
}

}  // namespace

void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::array<std::string, 3>& names, const std::string& path) {
  Held<NMR::PLib3MFModel> model;
  require(NMR::lib3mf_createmodel(model.out()), "start a model");
  require(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), "set the unit");
  require(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid(1, 1).c_str()), "name the build");
  require(NMR::lib3mf_model_addmetadatautf8(model.get(), "Title", escaped(title).c_str()),
          "set the title");
  Held<NMR::PLib3MFModelBaseMaterial> materials;
  require(NMR::lib3mf_model_addbasematerialgroup(model.get(), materials.out()), "add colours");
  DWORD group = 0;
  require(NMR::lib3mf_basematerial_getresourceid(materials.get(), &group), "add colours");
  std::array<DWORD, 3> material{};
  for (int k = 0; k < 3; ++k) {
    const Colour c = body_colour(static_cast<BodyKind>(k));
    require(NMR::lib3mf_basematerial_addmaterialutf8(materials.get(), names[k].c_str(), c.red,
                                                     c.green, c.blue, &material[k]),
            "add a colour");
    // Without this it would be transparent.
    require(NMR::lib3mf_basematerial_setdisplaycolorrgba(materials.get(), material[k], c.red,
                                                         c.green, c.blue, 255),
            "make a colour opaque");
  }
  int piece_count = 0;
  for (const BodyMesh& mesh : meshes) piece_count = std::max(piece_count, mesh.piece + 1);
  std::vector<std::vector<Body>> bodies(piece_count);
  unsigned number = 0;
  for (const BodyMesh& mesh : meshes) {
    if (++number % 64 == 0) {
      checkpoint("writing 3MF", static_cast<double>(number) / meshes.size());
    }
    std::vector<NMR::MODELMESHVERTEX> points(mesh.points.size());
    std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int k = 0; k < 3; ++k) points[i].m_fPosition[k] = static_cast<float>(mesh.points[i][k]);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) triangles[i].m_nIndices[k] = mesh.triangles[i][k];
    }
    auto held = std::make_unique<Held<NMR::PLib3MFModelMeshObject>>();
    Held<NMR::PLib3MFModelMeshObject>& object = *held;
    require(NMR::lib3mf_model_addmeshobject(model.get(), object.out()), "add " + mesh.name);
    require(NMR::lib3mf_object_setnameutf8(object.get(), mesh.name.c_str()), "name " + mesh.name);
    require(NMR::lib3mf_object_setuuidutf8(object.get(), uuid(2, number).c_str()),
            "name " + mesh.name);
    require(NMR::lib3mf_meshobject_setgeometry(object.get(), points.data(),
                                               static_cast<DWORD>(points.size()), triangles.data(),
                                               static_cast<DWORD>(triangles.size())),
            "take the mesh of " + mesh.name);
    Held<NMR::PLib3MFDefaultPropertyHandler> property;
    require(NMR::lib3mf_object_createdefaultpropertyhandler(object.get(), property.out()),
            "colour " + mesh.name);
    require(NMR::lib3mf_defaultpropertyhandler_setbasematerial(
                property.get(), group, material[static_cast<int>(mesh.kind)]),
            "colour " + mesh.name);
    bodies[mesh.piece].push_back(std::move(held));
  }
  for (int piece = 0; piece < piece_count; ++piece) {
    place_piece(model.get(), bodies[piece], title, piece, piece_count);
  }
  Held<NMR::PLib3MFModelWriter> writer;
  require(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()), "make a writer");
  Archive archive;
  bool cancelled = false;
  require(NMR::lib3mf_writer_setprogresscallback(writer.get(), &ask_to_go_on, &cancelled),
          "watch the writer");
  const long written =
      NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(&Archive::write),
                                         reinterpret_cast<void*>(&Archive::seek), &archive);
  if (cancelled) throw Cancelled();
  require(written, "write the archive");
  write_bytes(path, plain_zip(archive.bytes));
}

}  // namespace curveups
