// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "curveups/core/checkpoint.hpp"
#include "curveups/fabrication/file_formats.hpp"

namespace curveups {
namespace {

void append(std::string& bytes, const Vec3& v) {
  for (int k = 0; k < 3; ++k) {
    const float x = static_cast<float>(v[k]);
    std::uint32_t bits;
    std::memcpy(&bits, &x, 4);
    append_number(bytes, bits, 4);
  }
}

}  // namespace

void write_stl(const std::vector<BodyMesh>& meshes, const std::string& title,
               const std::string& path) {
  std::uint32_t count = 0;
  for (const BodyMesh& mesh : meshes) count += static_cast<std::uint32_t>(mesh.triangles.size());
  std::size_t cut = std::min<std::size_t>(title.size(), 50);
  while (cut < title.size() && (title[cut] & 0xC0) == 0x80) --cut;  // no letter in two
  std::string bytes = "CurveUps " + title.substr(0, cut) + " (mm)";
  bytes.resize(80, ' ');
  bytes.reserve(84 + 50ull * count);
  append_number(bytes, count, 4);
  for (const BodyMesh& mesh : meshes) {
    checkpoint();
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
      const Vec3 normal = (b - a).cross(c - a);
      const double length = normal.norm();
      append(bytes, length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero()));
      append(bytes, a);
      append(bytes, b);
      append(bytes, c);
      bytes.append(2, '\0');
    }
  }
  write_bytes(path, bytes);
}

}  // namespace curveups
