// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "Model/COM/NMR_DLLInterfaces.h"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/file_formats.hpp"
#include "curveups/fabrication/print_files.hpp"
#include "support/designs.hpp"

namespace curveups {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    char folder[] = "/tmp/curveups-files-XXXXXX";
    ASSERT_NE(mkdtemp(folder), nullptr);
    folder_ = folder;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  std::size_t file_count() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  static PrintModel model() {
    test::SampleOptions o;
    o.rows = 2;
    o.columns = 3;
    return make_print_model(test::sample_design({}, o));
  }

  fs::path folder_;
};

TEST_F(Files, AreTheSameByteForByteEveryTime) {
  const PrintModel a = model(), b = model();
  write_step(a, "print", path("a.step"));
  write_step(b, "print", path("b.step"));
  write_3mf(a, "print", path("a.3mf"));
  write_3mf(b, "print", path("b.3mf"));
  write_stl(a, "print", path("a.stl"));
  write_stl(b, "print", path("b.stl"));
  for (const char* kind : {"step", "3mf", "stl"}) {
    const std::string first = read_file(folder_ / (std::string("a.") + kind));
    EXPECT_GT(first.size(), 1000u);
    EXPECT_TRUE(first == read_file(folder_ / (std::string("b.") + kind))) << kind;
  }
}

// True if triangles over points that are equal as written close up: every edge twice, opposed.
template <class Corner>
bool closed(const std::vector<std::array<Corner, 3>>& triangles) {
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const auto& t : triangles) {
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return !edges.empty();
}

using Facets = std::vector<std::array<std::array<float, 3>, 3>>;

Facets facets_of(const std::string& bytes) {
  std::uint32_t count;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(bytes.size(), 84 + 50u * count);
  Facets facets(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    std::memcpy(&facets[k], bytes.data() + 84 + 50 * k + 12, 36);
  }
  return facets;
}

double volume_of(const Facets& facets) {
  double volume = 0;
  for (const auto& facet : facets) {
    Eigen::Matrix3d m;
    for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = facet[i / 3][i % 3];
    volume += m.determinant() / 6;
  }
  return volume;
}

TEST_F(Files, StlIsWatertight) {
  const PrintModel s = model();
  write_stl(s, "tiles", path("a.stl"));
  const Facets facets = facets_of(read_file(path("a.stl")));
  EXPECT_TRUE(closed(facets));
  EXPECT_NEAR(volume_of(facets), s.volume("tiles"), 0.01 * s.volume("tiles"));
}

// CGAL reads the file as it is, without mending, as one shell around a solid of this volume, mm3.
void expect_solid_by_cgal(const std::string& path, double volume) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  ASSERT_TRUE(CGAL::IO::read_STL(path, points, triangles));
  ASSERT_TRUE(pmp::is_polygon_soup_a_polygon_mesh(triangles));
  CGAL::Surface_mesh<Point> mesh;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  ASSERT_TRUE(CGAL::is_closed(mesh));
  EXPECT_FALSE(pmp::does_self_intersect(mesh));
  EXPECT_TRUE(pmp::is_outward_oriented(mesh));
  auto shell = mesh.add_property_map<CGAL::Surface_mesh<Point>::Face_index, std::size_t>().first;
  EXPECT_EQ(pmp::connected_components(mesh, shell), 1u);
  EXPECT_NEAR(pmp::volume(mesh), volume, 1e-6 * volume);
}

TEST_F(Files, APieceOnBridgesIsOneClosedShellWhereItIsFused) {
  Parameters parameters;
  parameters.support = "breakaway";
  const PrintModel s = make_print_model(test::sample_design(parameters, {}));
  ASSERT_GT(s.supports.size(), 10u);
  ASSERT_TRUE(s.loose_tiles.empty());
  write_stl(s, "fused", path("a.stl"));
  const Facets facets = facets_of(read_file(path("a.stl")));
  double apart = 0;  // volume of bodies by themselves, overlaps twice
  for (const char* kind : {"tiles", "support", "anchors"}) apart += s.volume(kind);
  EXPECT_LT(volume_of(facets), apart);
  // A bridge, 0.8 mm thick, reaches bridge_depth into a body at each of its ends.
  const double overlaps =
      2 * bridge_depth * bridge_width * 0.8 * static_cast<double>(s.supports.size());
  EXPECT_GT(volume_of(facets), apart - 3 * overlaps);
  expect_solid_by_cgal(path("a.stl"), volume_of(facets));
  EXPECT_THROW(write_stl(model(), "fused", path("b.stl")), InvalidInput);
  {
    const ProgressScope stop(
        [](const std::string& what, double) { return what != "uniting bodies"; });
    EXPECT_THROW(write_stl(s, "fused", path("c.stl")), Cancelled);
  }
  EXPECT_FALSE(fs::exists(path("b.stl")) || fs::exists(path("c.stl")));
}

// Readers that know no ZIP64 see an empty scene otherwise.
TEST_F(Files, ThreeMfIsAPlainZip) {
  write_3mf(model(), "print", path("a.3mf"));
  const std::string zip = read_file(path("a.3mf"));
  EXPECT_EQ(zip.find(std::string("PK\6\6", 4)), std::string::npos);
  EXPECT_EQ(zip.substr(0, 4), std::string("PK\3\4", 4));
  EXPECT_EQ(zip.substr(zip.size() - 22, 4), std::string("PK\5\6", 4));
}

TEST_F(Files, ThreeMfHoldsEveryBodyByNameWatertight) {
  using namespace NMR;
  const PrintModel s = model();
  write_3mf(s, "print", path("a.3mf"));
  PLib3MFModel* model;
  PLib3MFModelReader* reader;
  PLib3MFModelResourceIterator* it;
  ASSERT_GE(lib3mf_createmodel(&model), 0);
  ASSERT_GE(lib3mf_model_queryreader(model, "3mf", &reader), 0);
  ASSERT_GE(lib3mf_reader_readfromfileutf8(reader, path("a.3mf").c_str()), 0);
  ASSERT_GE(lib3mf_model_getmeshobjects(model, &it), 0);
  std::set<std::string> names;
  BOOL more = 0;
  for (lib3mf_resourceiterator_movenext(it, &more); more;
       lib3mf_resourceiterator_movenext(it, &more)) {
    PLib3MFModelResource* object;
    ASSERT_GE(lib3mf_resourceiterator_getcurrent(it, &object), 0);
    char name[64] = "";
    ULONG length = 0;
    ASSERT_GE(lib3mf_object_getnameutf8(object, name, sizeof name, &length), 0);
    names.insert(name);
    DWORD points = 0, count = 0, got = 0;
    lib3mf_meshobject_getvertexcount(object, &points);
    lib3mf_meshobject_gettrianglecount(object, &count);
    std::vector<MODELMESHVERTEX> vertex(points);
    std::vector<MODELMESHTRIANGLE> triangle(count);
    ASSERT_GE(lib3mf_meshobject_getvertices(object, vertex.data(), points, &got), 0);
    ASSERT_GE(lib3mf_meshobject_gettriangleindices(object, triangle.data(), count, &got), 0);
    // Compare by coordinates, as a reader does that welds points.
    std::vector<std::array<std::array<float, 3>, 3>> corners(count);
    for (DWORD k = 0; k < count; ++k) {
      for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < 3; ++i) {
          corners[k][c][i] = vertex[triangle[k].m_nIndices[c]].m_fPosition[i];
        }
      }
    }
    EXPECT_TRUE(closed(corners)) << name;
    lib3mf_release(object);
  }
  lib3mf_release(it);
  lib3mf_release(reader);
  lib3mf_release(model);
  std::set<std::string> expected;
  for (const PrintBody* body : s.bodies("print")) expected.insert(body->name);
  EXPECT_EQ(names, expected);
}

TEST_F(Files, FailuresAndCancellingLeaveNothingBehind) {
  const PrintModel s = model();
  EXPECT_THROW(write_step(s, "tiles", path("missing/a.step")), IoError);
  EXPECT_THROW(write_stl(s, "tiles", path("missing/a.stl")), IoError);
  EXPECT_THROW(write_3mf(s, "print", path("missing/a.3mf")), IoError);
  fs::create_directory(folder_ / "folder");
  EXPECT_THROW(write_step(s, "tiles", path("folder")), IoError);
  EXPECT_THROW(write_step(s, "no such kind", path("a.step")), InvalidInput);
  const ProgressScope stop([](const std::string&, double) { return false; });
  EXPECT_THROW(write_step(s, "tiles", path("a.step")), Cancelled);
  EXPECT_THROW(write_stl(s, "tiles", path("a.stl")), Cancelled);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, AFullDiskIsAnError) {
  EXPECT_THROW(write_bytes("/dev/full", std::string(1 << 16, 'x')), IoError);
}

}  // namespace
}  // namespace curveups
