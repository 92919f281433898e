// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include "Model/COM/NMR_DLLInterfaces.h"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/fabrication/atomic_file.hpp"
#include "curveups/fabrication/mesh_files.hpp"
#include "curveups/fabrication/palette.hpp"

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

// The file's clock: lib3mf stamps every part of the archive with the present time. The stamps are
// set to the earliest that ZIP knows (1980-01-01 00:00) in local and central headers.
void strip_dates(std::string& zip) {
  auto u16 = [&](std::size_t at) {
    return static_cast<unsigned char>(zip[at]) | static_cast<unsigned char>(zip[at + 1]) << 8;
  };
  auto u32 = [&](std::size_t at) {
    return static_cast<std::size_t>(u16(at)) | static_cast<std::size_t>(u16(at + 2)) << 16;
  };
  auto stamp = [&](std::size_t at) {
    zip[at] = zip[at + 1] = 0;
    zip[at + 2] = 0x21;
    zip[at + 3] = 0;
  };
  const std::size_t end = zip.rfind(std::string("PK\5\6", 4));
  if (end == std::string::npos || end + 22 > zip.size()) return;
  std::size_t at = u32(end + 16);
  for (int entry = u16(end + 10); entry > 0 && at + 46 <= zip.size(); --entry) {
    if (zip.compare(at, 4, std::string("PK\1\2", 4)) != 0) return;
    const std::size_t local = u32(at + 42);
    if (local + 30 > zip.size()) return;
    stamp(at + 12);
    stamp(local + 10);
    at += 46 + u16(at + 28) + u16(at + 30) + u16(at + 32);
  }
}

}  // namespace

void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path, const Progress& progress) {
  Held<NMR::PLib3MFModel> model;
  require(NMR::lib3mf_createmodel(model.out()), "start a model");
  require(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), "set the unit");
  require(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid(1, 1).c_str()), "name the build");
  require(NMR::lib3mf_model_addmetadatautf8(model.get(), "Title", title.c_str()), "set the title");
  Held<NMR::PLib3MFModelBaseMaterial> materials;
  require(NMR::lib3mf_model_addbasematerialgroup(model.get(), materials.out()), "add colours");
  DWORD group = 0;
  require(NMR::lib3mf_basematerial_getresourceid(materials.get(), &group), "add colours");
  std::array<DWORD, 3> material{};
  const std::array<const char*, 3> names = {"tile", "support", "anchor"};
  for (int k = 0; k < 3; ++k) {
    const Colour c = body_colour(static_cast<BodyKind>(k));
    require(NMR::lib3mf_basematerial_addmaterialutf8(materials.get(), names[k], c.red, c.green,
                                                     c.blue, &material[k]),
            "add a colour");
  }
  unsigned number = 0;
  for (const BodyMesh& mesh : meshes) {
    if (++number % 64 == 0 &&
        !keep_going(progress, "writing 3MF", static_cast<double>(number) / meshes.size())) {
      throw Cancelled();
    }
    std::vector<NMR::MODELMESHVERTEX> points(mesh.points.size());
    std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int k = 0; k < 3; ++k) points[i].m_fPosition[k] = static_cast<float>(mesh.points[i][k]);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) triangles[i].m_nIndices[k] = mesh.triangles[i][k];
    }
    Held<NMR::PLib3MFModelMeshObject> object;
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
    Held<NMR::PLib3MFModelBuildItem> item;
    require(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.out()),
            "place " + mesh.name);
    require(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid(3, number).c_str()),
            "place " + mesh.name);
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
  strip_dates(archive.bytes);
  write_atomically(path,
                   [&](const std::string& temporary) { write_bytes(temporary, archive.bytes); });
}

}  // namespace curveups
