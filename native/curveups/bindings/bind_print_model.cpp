// SPDX-License-Identifier: LGPL-2.1-or-later
// The print model: figures, bodies and files.
#include "curveups/actuation/flat_piece.hpp"
#include "curveups/bindings/arrays.hpp"
#include "curveups/bindings/bindings.hpp"
#include "curveups/bodies/body_checks.hpp"
#include "curveups/bodies/clearance.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/body_mesh.hpp"
#include "curveups/fabrication/brep_text.hpp"
#include "curveups/fabrication/print_files.hpp"
#include "curveups/fabrication/ring.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups::bindings {

namespace {

constexpr const char* printed_kinds[] = {"tiles", "support", "anchors"};

// Deletion of thousands of bodies takes a while; other threads run meanwhile.
struct DeletedWithoutGil {
  void operator()(PrintModel* model) const {
    const py::gil_scoped_release release;
    delete model;
  }
};
using HeldModel = std::unique_ptr<PrintModel, DeletedWithoutGil>;

// Points, triangles and the body of each triangle.
std::tuple<Points3, Triangles, Eigen::VectorXi> joined(const std::vector<BodyMesh>& meshes) {
  Eigen::Index points = 0, triangles = 0;
  for (const BodyMesh& mesh : meshes) {
    points += static_cast<Eigen::Index>(mesh.points.size());
    triangles += static_cast<Eigen::Index>(mesh.triangles.size());
  }
  std::tuple<Points3, Triangles, Eigen::VectorXi> out{Points3(points, 3), Triangles(triangles, 3),
                                                      Eigen::VectorXi(triangles)};
  auto& [V, F, body] = out;
  Eigen::Index point = 0, triangle = 0;
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const int first = static_cast<int>(point);
    for (const auto& [a, b, c] : meshes[k].triangles) {
      body(triangle) = static_cast<int>(k);
      F.row(triangle++) << a + first, b + first, c + first;
    }
    for (const Vec3& p : meshes[k].points) V.row(point++) = p;
  }
  return out;
}

}  // namespace

void bind_print_model(py::module_& module) {
  FiguresClass<GluedAreas>(module, "GluedAreas", "Areas in the plane of one side's pin tops, mm2.")
      .figure("pins", &GluedAreas::pins)
      .figure("anchors", &GluedAreas::anchors)
      .figure("support", &GluedAreas::support);
  py::class_<PrintBody>(module, "PrintBody", "One body of a print.")
      .def_readonly("name", &PrintBody::name)
      .def_readonly("tile", &PrintBody::tile, "Row of F; -1: support or anchor.")
      .def_readonly("piece", &PrintBody::piece, "The piece, or the part, that it belongs to.")
      .def_property_readonly(
          "faces", [](const PrintBody& b) { return b.faces.size(); }, "Number of planar faces.")
      .def_property_readonly(
          "volume", [](const PrintBody& b) { return volume(b); }, "mm3, exact.");
  using Bodies = std::vector<const PrintBody*>;
  module.def(
      "check_bodies",
      [](const Bodies& bodies, const Progress& progress) {
        const ProgressScope scope(progress);
        checkpoint("checking solids", 0);
        std::vector<std::string> reasons(bodies.size());
        parallel_each(static_cast<int>(bodies.size()),
                      [&](int i) { reasons[i] = unsoundness(*bodies[i]); });
        return reasons;
      },
      py::arg("bodies"), py::arg("progress") = py::none(), Released(),
      "Why the boundary of each body is unsound; empty for a sound one.");
  module.def(
      "brep_texts",
      [](const Bodies& bodies) {
        std::vector<std::string> texts = brep_texts(bodies);
        const py::gil_scoped_acquire acquire;
        py::list out;
        for (std::string& text : texts) {
          out.append(py::bytes(text));
          std::string().swap(text);
        }
        return out;
      },
      py::arg("bodies"), Released(),
      "The solid of each body, as Part.Shape.importBrep reads it from a file.");
  py::class_<PrintModel, HeldModel>(
      module, "PrintModel",
      "All that is printed. Kinds: tiles, support, anchors, print (all) and actuated (the tiles in "
      "the target shape, without bumps). Lengths in mm, volumes in mm3.")
      .def_readonly("name", &PrintModel::name)
      .def_readonly("piece_count", &PrintModel::piece_count)
      .def_property_readonly("tile_count", [](const PrintModel& m) { return m.tiles.size(); })
      .def_property_readonly("body_count",
                             [](const PrintModel& m) { return m.bodies("print").size(); })
      .def_property_readonly("bbox", [](const PrintModel& m) { return Vec3(m.box.sizes()); })
      .def_property_readonly("volumes",
                             [](const PrintModel& m) {
                               py::dict out;
                               for (const char* kind : printed_kinds) out[kind] = m.volume(kind);
                               return out;
                             })
      .def_property_readonly(
          "thinnest",
          [](const PrintModel& m) {
            py::list out;
            for (const ThinFeature& thin : m.thin) {
              out.append(py::make_tuple(thin.body, thin.what, thin.size, thin.tile));
            }
            return out;
          },
          "Per body that has a size of its own: its name, its narrowest place and how wide that "
          "is.")
      .def_property_readonly(
          "bare_interfaces",
          [](const PrintModel& m) {
            py::list out;
            for (const BareInterface& bare : m.bumps.bare) {
              const Contact& contact = m.geometry.tiles.contacts[bare.contact];
              out.append(py::make_tuple(contact.tile[0], contact.tile[1], bare.reason));
            }
            return out;
          },
          "Contacts without bumps: their two tiles and why.")
      .def_property_readonly(
          "joints",
          [](const PrintModel& m) {
            py::list joined, closed;
            std::vector<char> open(m.joints.joints.size(), 1);
            for (int k : m.joints.closed) open[k] = 0;
            for (std::size_t k = 0; k < open.size(); ++k) {
              const auto [a, b] = m.joints.joints[k].tile;
              (open[k] ? joined : closed).append(py::make_tuple(a, b));
            }
            std::size_t holes = 0;
            for (const auto& row : m.joints.of_tile) holes += row.size();
            return py::make_tuple(joined, closed, holes);
          },
          "With joint=holes the pairs of tiles along borders of pieces with stitching holes, those "
          "without room for them, and how many holes there are in all.")
      .def_readonly("loose_tiles", &PrintModel::loose_tiles)
      .def_readonly("loose_anchors", &PrintModel::loose_anchors)
      .def_readonly("overhangs", &PrintModel::overhang,
                    "Per tile how far its body reaches out level beyond the pin on the bed.")
      .def_property_readonly(
          "glued_areas",
          [](const PrintModel& m) {
            py::dict out;
            for (const Side side : {Side::front, Side::back}) {
              out[side_name(side)] = py::cast(glued_areas(m, side)).attr("block");
            }
            return out;
          },
          "Areas in the plane of the pin tops by side, mm2: pins, anchors and support.")
      .def(
          "min_clearance_flat", [](const PrintModel& m) { return min_clearance_flat(m).value; },
          Released())
      .def("bodies", &PrintModel::bodies, py::arg("kind"),
           py::return_value_policy::reference_internal, "The bodies of a kind.")
      .def(
          "mesh",
          [](const PrintModel& m, const std::string& kind) {
            return joined(mesh_bodies(m.bodies(kind), {0.1, false}));
          },
          py::arg("kind"), Released(),
          "Triangles of a kind's bodies, without bumps, for pictures: points (n x 3), triangles "
          "(m x 3, counter-clockwise seen from outside) and the body of each triangle, from 0.")
      .def(
          "only_tiles",
          [](const PrintModel& m, const std::vector<int>& tiles) {
            require_tiles(tiles, static_cast<Eigen::Index>(m.tiles.size()), "tiles");
            return only_tiles(m, tiles);
          },
          py::arg("tiles"), "These tiles (rows of F) alone, at their places: spares.")
      .def(
          "only_pieces",
          [](const PrintModel& m, const std::map<int, std::array<double, 3>>& places) {
            std::map<int, RigidMotion> motions;
            for (const auto& [piece, place] : places) {
              const double angle = place[2] * 3.141592653589793 / 180;
              RigidMotion& motion = motions[piece];
              motion.R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
              motion.t = Vec3(place[0], place[1], 0);
            }
            return only_pieces(m, motions);
          },
          py::arg("places"),
          "These pieces, or parts, alone; each with its move (x, y, mm) after its turn (degrees) "
          "about the origin.")
      .def_readonly("outlines", &PrintModel::outlines,
                    "Polygons of each slab: its outline, then its holes.")
      .def(
          "posed",
          [](const PrintModel& m, const FrameRows& poses) {
            return move_actuated(m, frame_motions(poses, static_cast<int>(m.actuated.size())));
          },
          py::arg("poses"), "The same with the actuated tiles where a frame has them.")
      .def(
          "write",
          [](const PrintModel& m, const std::string& ending, const std::string& kind,
             const std::string& path, const Progress& progress, const Title& title) {
            const ProgressScope scope(progress);
            print_format(ending).write(m, kind, path, title);
          },
          py::arg("ending"), py::arg("kind"), py::arg("path"), py::arg("progress") = py::none(),
          py::arg("title") = py::none(), Released(),
          "Writes a file of one kind of bodies, in the format of that ending (print_formats). "
          "title: stands inside of the file; by default the model's name.");
  py::class_<PrintFormat>(module, "PrintFormat", "A format of a print's files.")
      .def_readonly("ending", &PrintFormat::ending)
      .def_readonly("kinds", &PrintFormat::kinds, "Kinds of bodies, a file each.")
      .def_readonly("wanted", &PrintFormat::wanted, "Kinds that print shops want in this format.");
  module.def("print_formats", &print_formats, py::return_value_policy::reference,
             "The formats of a print's files, in their order.");
  py::class_<SupportKind>(module, "SupportKind", "Properties of a kind of support.")
      .def_readonly("bodies", &SupportKind::bodies, "Name of its bodies; empty: there are none.")
      .def_readonly("material", &SupportKind::material)
      .def_readonly("removal", &SupportKind::removal, "Its removal, as a step of the assembly.")
      .def_readonly("soluble", &SupportKind::soluble,
                    "Printed of a second material, which a bath dissolves.");
  module.def("support_kind", &support_kind, py::arg("parameters"),
             "The kind of support that the parameters ask for.");
  module.def(
      "measure_clearances",
      [](const Design& design, const Progress& progress) {
        const ProgressScope scope(progress);
        checkpoint("measuring clearances");
        const TileBodies bodies = make_tile_bodies(design);
        const PairFigure flat = min_clearance_flat(bodies);
        const PairFigure actuated = max_overlap_actuated(bodies);
        return std::make_tuple(flat.value, actuated.value, body_reasons(flat, actuated));
      },
      py::arg("design"), py::arg("progress") = py::none(), Released(),
      "Least distance of two tiles as printed (mm, exact, bumps included; infinite with one tile), "
      "largest volume that two share when actuated (mm3), and the reasons for which these make the "
      "design not valid: all without solids. Raises InfeasibleDesign where tiles "
      "can't be made.");
  using Points = std::vector<Vec2>;
  module.def(
      "make_print_model",
      [](const Design& design, const Progress& progress, const std::vector<int>& part_of_tile,
         double opening, const Points& region) {
        const ProgressScope scope(progress);
        checkpoint("building bodies");
        return make_print_model(design, {part_of_tile, opening, region});
      },
      py::arg("design"), py::arg("progress") = py::none(),
      py::arg("part_of_tile") = std::vector<int>(), py::arg("opening") = 0.0,
      py::arg("region") = Points(), Released(),
      "The print of a design; raises InfeasibleDesign, naming tiles, where it can't be made. For "
      "beds that are too small: part_of_tile, by rows of F (empty: all are one), between which "
      "slabs are cut along "
      "gaps and lie `opening` mm apart; region, a convex polygon in the layout's plane: anchors "
      "beyond it are left out, and slabs end at it.");
  module.def(
      "make_ring",
      [](const std::string& name,
         const std::vector<std::tuple<Points, Points, Points, Points>>& parts, double thickness,
         double tooth_radius, double tooth_height) {
        std::vector<RingPart> plates;
        for (const auto& [outline, window, teeth, holes] : parts) {
          plates.push_back({outline, window, teeth, holes});
        }
        return make_ring(name, plates, thickness, tooth_radius, tooth_height);
      },
      py::arg("name"), py::arg("parts"), py::arg("thickness"), py::arg("tooth_radius"),
      py::arg("tooth_height"),
      "A ring that holds a stretched sheet, as bodies of kind tiles: plates from z = 0 to "
      "thickness, with teeth that are round on top. Of each part, seen from the teeth: outline and "
      "window (empty: none), both counter-clockwise, places of teeth, places of holes as wide as "
      "these.");
  py::dict colours;
  for (int k = 0; k < 3; ++k) {
    const Colour c = body_colour(static_cast<BodyKind>(k));
    colours[printed_kinds[k]] = py::make_tuple(c.red, c.green, c.blue);
  }
  module.attr("COLOURS") = colours;  // sRGB by kind of bodies, 0 to 255, as in STEP and 3MF
  module.attr("SUPPORT_MARGIN") = support_margin;  // these in mm (print_constants.hpp)
  module.attr("ANCHOR_DISTANCE") = anchor_distance;
  module.attr("ANCHOR_SPACING") = anchor_spacing;
  module.attr("JOINT_HOLE") = joint_hole;
  module.attr("DIMPLE_CLEARANCE") = dimple_clearance;
}

}  // namespace curveups::bindings
