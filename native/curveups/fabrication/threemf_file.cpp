// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/compile.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <new>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/fabrication/file_formats.hpp"

namespace curveups {
namespace {

// Members of a ZIP, compressed and dated 1980-01-01 00:00, the earliest date of ZIP. No ZIP64: some
// slicers and viewers do not read it.
class Archive {
 public:
  // Adds a member whose text `write` hands over in parts.
  template <class Write>
  void add(const std::string& name, const Write& write) {
    Deflated member;
    write([&](const std::string& part) { member.append(part, Z_NO_FLUSH); });
    member.append("", Z_FINISH);
    if (std::max<std::uint64_t>(member.size, bytes_.size() + member.packed.size()) > most_bytes) {
      throw IoError("the 3MF would have more than 4 GB, which slicers do not read",
                    "raise mesh_deviation");
    }
    std::string common;            // fields that both headers share
    append_number(common, 20, 4);  // version that readers need, no flags
    append_number(common, 8, 2);   // deflated
    append_number(common, 0x00210000, 4);
    append_number(common, member.checksum, 4);
    append_number(common, member.packed.size(), 4);
    append_number(common, member.size, 4);
    append_number(common, name.size(), 4);  // and no extra field
    directory_ += "PK\1\2";
    append_number(directory_, 20, 2);
    directory_ += common;
    directory_.append(10, '\0');  // no comment, first disk, no attributes
    append_number(directory_, bytes_.size(), 4);
    directory_ += name;
    bytes_ += "PK\3\4" + common + name + member.packed;
    ++members_;
  }

  std::string finish() {
    const std::size_t begin = bytes_.size();
    bytes_ += directory_ + "PK\5\6";
    append_number(bytes_, 0, 4);
    append_number(bytes_, members_, 2);
    append_number(bytes_, members_, 2);
    append_number(bytes_, directory_.size(), 4);
    append_number(bytes_, begin, 4);
    append_number(bytes_, 0, 2);
    return std::move(bytes_);
  }

 private:
  static constexpr std::size_t most_bytes = 0xfffffffe;
  static constexpr int level = 4;  // zlib: half the time of its default, a tenth more bytes

  // Deflate without zlib's header and checksum, which a ZIP has not.
  struct Deflated {
    Deflated() {
      if (deflateInit2(&stream_, level, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
        throw std::bad_alloc();
      }
    }
    ~Deflated() { deflateEnd(&stream_); }
    Deflated(const Deflated&) = delete;
    Deflated& operator=(const Deflated&) = delete;

    void append(const std::string& text, int flush) {
      const auto* const bytes = reinterpret_cast<const Bytef*>(text.data());
      size += text.size();
      checksum = crc32_z(checksum, bytes, text.size());
      stream_.next_in = const_cast<Bytef*>(bytes);
      stream_.avail_in = static_cast<uInt>(text.size());
      do {
        stream_.next_out = buffer_.data();
        stream_.avail_out = static_cast<uInt>(buffer_.size());
        deflate(&stream_, flush);
        packed.append(buffer_.begin(), buffer_.end() - stream_.avail_out);
      } while (stream_.avail_out == 0);
    }

    std::string packed;
    std::uint64_t size = 0;  // text, bytes
    uLong checksum = 0;

   private:
    z_stream stream_{};
    std::vector<Bytef> buffer_ = std::vector<Bytef>(1 << 16);
  };

  std::string bytes_, directory_;
  std::size_t members_ = 0;
};

constexpr const char* content_types = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* relationships = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rel0" Target="/3D/3dmodel.model"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

constexpr const char* model_head = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US"
 xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
)";

// Escapes text of XML; control characters, which it can't hold, are left out.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (static_cast<unsigned char>(letter) < ' ') continue;
    out += letter == '&'   ? "&amp;"
           : letter == '<' ? "&lt;"
           : letter == '>' ? "&gt;"
           : letter == '"' ? "&quot;"
                           : std::string(1, letter);
  }
  return out;
}

template <class Number>
void append_attribute(std::string& xml, const char* name, Number value) {
  char digits[40];
  xml += name;
  xml.append(digits, fmt::format_to(digits, FMT_COMPILE("{}"), value));
  xml += '"';
}

std::string material(const std::string& name, BodyKind kind) {
  const Colour c = body_colour(kind);
  char colour[12];
  std::snprintf(colour, sizeof colour, "#%02X%02X%02XFF", c.red, c.green, c.blue);
  return "<base name=\"" + escaped(name) + "\" displaycolor=\"" + colour + "\"/>\n";
}

void append_mesh(std::string& xml, const BodyMesh& mesh, int id) {
  append_attribute(xml, "<object id=\"", id);
  xml += " type=\"model\" name=\"" + escaped(mesh.name) + "\" pid=\"1\"";
  append_attribute(xml, " pindex=\"", static_cast<int>(mesh.kind));
  xml += "><mesh><vertices>\n";
  for (const Vec3& p : mesh.points) {
    if (!p.allFinite()) {
      throw SolverFailure("a coordinate of a solid is not finite",
                          "report this with the design file");
    }
    append_attribute(xml, "<vertex x=\"", static_cast<float>(p.x()));
    append_attribute(xml, " y=\"", static_cast<float>(p.y()));
    append_attribute(xml, " z=\"", static_cast<float>(p.z()));
    xml += "/>\n";
  }
  xml += "</vertices><triangles>\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    append_attribute(xml, "<triangle v1=\"", a);
    append_attribute(xml, " v2=\"", b);
    append_attribute(xml, " v3=\"", c);
    xml += "/>\n";
  }
  xml += "</triangles></mesh></object>\n";
}

}  // namespace

void write_3mf(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::array<std::string, 3>& materials, const std::string& path) {
  Archive archive;
  archive.add("[Content_Types].xml", [](const auto& write) { write(content_types); });
  archive.add("_rels/.rels", [](const auto& write) { write(relationships); });
  archive.add("3D/3dmodel.model", [&](const auto& write) {
    std::string xml = model_head;
    xml += "<metadata name=\"Title\">" + escaped(title) +
           "</metadata>\n<resources>\n<basematerials id=\"1\">\n";
    for (int k = 0; k < 3; ++k) xml += material(materials[k], static_cast<BodyKind>(k));
    xml += "</basematerials>\n";
    int id = 1;
    std::map<int, std::string> pieces;  // components
    for (const BodyMesh& mesh : meshes) {
      if (++id % 64 == 0) checkpoint("writing 3MF", static_cast<double>(id) / (2 + meshes.size()));
      append_mesh(xml, mesh, id);
      write(xml);
      xml.clear();
      append_attribute(pieces[mesh.piece], "<component objectid=\"", id);
      pieces[mesh.piece] += "/>\n";
    }
    std::string items;
    for (const auto& [piece, components] : pieces) {
      append_attribute(xml, "<object id=\"", ++id);
      const std::string name = pieces.size() > 1 ? title + " P" + std::to_string(piece + 1) : title;
      xml += " type=\"model\" name=\"" + escaped(name) + "\"><components>\n" + components +
             "</components></object>\n";
      append_attribute(items, "<item objectid=\"", id);
      items += "/>\n";
    }
    write(xml + "</resources>\n<build>\n" + items + "</build>\n</model>\n");
  });
  write_bytes(path, archive.finish());
}

}  // namespace curveups
