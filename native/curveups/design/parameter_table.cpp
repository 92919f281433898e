// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/membrane_models.hpp"
#include "curveups/design/parameters.hpp"
#include "curveups/design/support_kinds.hpp"

namespace curveups {
namespace {

using P = Parameters;

#define CURVEUPS_CHOICE(function, name) name,

// clang-format off
std::vector<ParameterInfo> make_table() {
  using namespace reader;
  using namespace trait;
  return {
    {"scale", "", "Target",
     "Multiply the coordinates of a file without units by this factor (1000 for metres).",
     basic, target, &P::scale, 1e-6, 1e6},
    {"flip", "", "Target",
     "Swap front and back. Use this for a target whose normals point inwards.",
     basic, target, &P::flip},
    {"skin", "", "Target", "Choose which side of a CAD part with a wall becomes the target.",
     0, target, &P::skin, 0, 0, {"outer", "inner", "middle"}},
    {"faces", "", "Target",
     "List the faces of a CAD part that become the target, such as Face3,Face7-9. Skin and "
     "open choose them where the list is empty.",
     0, target, &P::faces, 0, 0, {}, "faces"},
    {"open", "", "Target",
     "Choose what a closed CAD part loses: its largest planar face (auto, largest), the faces "
     "in a plane (z=0), all below a plane (z>0), all above it (z<0), or nothing (none).",
     0, target, &P::open, 0, 0, {}, "opening"},
    {"L", "mm", "Target", "Mean edge length of the tiles. With --no-remesh the mesh decides.",
     basic, target | tiles, &P::L, 0.5, 200},
    {"maximum_deviation", "mm", "Target", "L=auto keeps the tiles within this distance of the target.",
     0, target, &P::maximum_deviation, 1e-3, 100},
    {"crease_angle", "deg", "Target",
     "Keep creases of the target that are sharper than this as edges between tiles. 180 keeps "
     "none.",
     basic, target, &P::crease_angle, 1, 180},
    {"mend", "", "Target",
     "Choose what happens to a target that can't become tiles: off refuses it, on changes it.",
     basic, target, &P::mend, 0, 0, {"off", "on"}},
    {"mend_max", "mm", "Target",
     "Largest distance by which mending may move a point of the target.",
     0, target, &P::mend_max, 0, 1000},
    {"pieces", "", "Target",
     "Number of pieces that the target is divided into (1 to 24). auto finds the smallest "
     "number that lies flat.",
     basic, pieces, &P::pieces, 0, 0, {}, "pieces"},
    {"joint", "", "Target",
     "Choose how pieces are joined after printing: holes gives the tiles along their borders "
     "stitching holes.",
     0, tiles, &P::joint, 0, 0, {"none", "holes"}},
    {"H_body", "mm", "Tiles", "Thickness of a tile from its front face to its back face.",
     basic | keeps_layout, tiles, &P::H_body, 0.2, 100},
    {"H_pin", "mm", "Tiles",
     "Height of the pins. The membranes are glued to the tops of the pins.",
     basic | keeps_layout, tiles, &P::H_pin, 0.05, 50},
    {"d_gap_min", "mm", "Layout",
     "Least distance between two tiles in the flat layout. Bumps on walls that are not "
     "recessed stand in this gap.",
     basic, layout | bodies | support, &P::d_gap_min, 0, 20},
    {"p_min", "mm", "Layout",
     "Least distance from the edge of a pin to the (recessed) edge of its face.",
     basic, tiles, &P::p_min, 0, 20},
    {"p_floor", "mm", "Layout",
     "Smallest value to which p_min may shrink at sharp folds. Use the smallest feature that "
     "the printer makes.",
     0, tiles, &P::p_floor, 0, 20},
    {"p_max", "mm", "Layout",
     "Largest distance from the edge of a pin to the edge of its face. Pins farther away pull "
     "too weakly.",
     0, tiles, &P::p_max, 0, 50},
    {"A_pin_min", "mm2", "Layout", "Area that a pin's top gets where there is room. It makes the glue hold.",
     basic, tiles, &P::A_pin_min, 0, 1000},
    {"A_pin_floor", "mm2", "Layout", "Least area of a pin's top. A smaller pin makes the design invalid.",
     0, tiles, &P::A_pin_floor, 0, 1000},
    {"tau", "", "Layout",
     "Stretch ratio of the membranes when they are glued. 3 gives nine times the area.",
     basic, layout | physics, &P::tau, 1.05, 8},
    {"bumps", "", "Bumps",
     "Choose what keeps contacts from sliding: bumps, dimples (bumps that snap into hollows) "
     "or nothing (none).",
     basic | keeps_layout, tiles, &P::bumps, 0, 0, {"bumps", "dimples", "none"}},
    {"bump_height", "mm", "Bumps", "Height of a friction bump above its wall.",
     basic | keeps_layout, tiles, &P::bump_height, 0.02, 5},
    {"xy_compensation", "mm", "Bumps",
     "Move each wall that meets another one without bumps back by this. It makes up for the "
     "growth of printed walls (XY compensation).",
     keeps_layout, tiles, &P::xy_compensation, 0, 1},
    {"support", "", "Support",
     "Choose what holds the layout together after printing: a soluble slab, breakaway bridges "
     "or nothing (none).",
     basic | keeps_layout, layout | support, &P::support, 0, 0,
     {CURVEUPS_SUPPORT_KINDS(CURVEUPS_CHOICE)}},
    {"orientation", "", "Support",
     "Choose which side faces up in the print. With front-down, breakaway bridges span "
     "between walls that stand already.",
     basic | keeps_layout, support, &P::orientation, 0, 0, {"front-up", "front-down"}},
    {"anchors", "", "Anchors",
     "Add cylinders around the layout that carry the pull of the surplus membrane.",
     basic | keeps_layout, layout | support, &P::anchors},
    {"anchor_radius", "mm", "Anchors", "Radius of an anchor.",
     keeps_layout, layout | support, &P::anchor_radius, 0.5, 100},
    {"printer", "", "Files", "Compare the print with the bed, gaps and features of this printer.",
     basic | keeps_layout, check, &P::printer, 0, 0, {"polyjet", "resin", "fdm"}},
    {"mesh_deviation", "mm", "Files",
     "Largest distance of STL and 3MF facets from the curved surfaces (chord error).",
     basic | keeps_layout, files, &P::mesh_deviation, 1e-4, 1},
    {"check_all", "", "Files",
     "Let OpenCASCADE check the solids of all bodies, slabs too, instead of 16 of each kind.",
     keeps_layout, check, &P::check_all},
    {"shear_modulus_front", "MPa", "Physics", "Shear modulus of the front membrane (latex).",
     basic | keeps_layout, physics, &P::shear_modulus_front, 1e-3, 1e3},
    {"shear_modulus_back", "MPa", "Physics", "Shear modulus of the back membrane (latex).",
     basic | keeps_layout, physics, &P::shear_modulus_back, 1e-3, 1e3},
    {"thickness_front", "mm", "Physics", "Thickness of the front membrane before it is stretched.",
     basic | keeps_layout, physics, &P::thickness_front, 0.01, 10},
    {"thickness_back", "mm", "Physics", "Thickness of the back membrane before it is stretched.",
     basic | keeps_layout, physics, &P::thickness_back, 0.01, 10},
    {"elongation_at_break", "%", "Physics",
     "Elongation at which the membranes break, as their maker states it. The report warns "
     "where they stretch further.",
     keeps_layout, physics, &P::elongation_at_break, 1, 5000},
    {"glue_strength", "MPa", "Physics",
     "Shear stress that the glue between membranes and print withstands. A warning names pins "
     "that carry more. The verdict does not depend on it.",
     keeps_layout, physics, &P::glue_strength, 1e-3, 100},
    {"membrane_model", "", "Physics",
     "Choose the energy of the membranes: tension-field (neo-Hookean; they wrinkle where "
     "squeezed) or plain neo-hookean.",
     keeps_layout, physics, &P::membrane_model, 0, 0, {CURVEUPS_MEMBRANE_MODELS(CURVEUPS_CHOICE)}},
    {"friction_coefficient", "", "Physics",
     "Coefficient of Coulomb friction between tiles, also at bumps.",
     basic | keeps_layout, physics, &P::friction_coefficient, 0.01, 10},
    {"hold_tolerance", "mm", "Physics",
     "The shape holds where friction lets it drift by this at most, in the mean. 0 stands for "
     "1 % of L.",
     keeps_layout, reader::settle, &P::hold_tolerance, 0, 100},
    {"margin", "", "Physics",
     "Choose what is asked about margin_mismatch and margin_friction: nothing (off), a warning "
     "where the design does not bear them (report), or that it does (require).",
     keeps_layout, reader::settle, &P::margin, 0, 0, {"off", "report", "require"}},
    {"margin_mismatch", "%", "Physics",
     "How much harder than the other either membrane may pull within the margin.",
     keeps_layout, reader::settle, &P::margin_mismatch, 0, 90},
    {"margin_friction", "", "Physics",
     "Least coefficient of friction within the margin.",
     keeps_layout, reader::settle, &P::margin_friction, 0.01, 10},
    {"window", "", "Physics",
     "Find how far front and back membrane may differ in pull and how far friction may change, each "
     "alone, until the shape no longer holds.",
     keeps_layout, reader::settle, &P::window},
    {"f_min_ratio", "", "Physics",
     "Least normal force at each contact point, as a fraction of the mean normal force.",
     keeps_layout, physics, &P::f_min_ratio, 0, 1},
    {"gravity", "", "Physics",
     "Choose what carries the weight of the tiles: nothing (off leaves it out), the held "
     "tiles (held), or a plane below the piece (resting).",
     keeps_layout, physics, &P::gravity, 0, 0, {"off", "held", "resting"}},
    {"held_tiles", "", "Physics",
     "List the tiles that carry the piece with gravity=held, such as T00012,T00345. An empty "
     "list stands for the lowest tiles.",
     keeps_layout, physics, &P::held_tiles, 0, 0, {}, "tiles"},
    {"density", "g/cm3", "Physics", "Density of the tiles. It gives them their weight.",
     keeps_layout, physics, &P::density, 0, 30},
    {"self_shaping", "", "Repair",
     "Move pins and tiles after repair until the design needs as little friction as it can, so that "
     "the piece comes to rest near the target by itself.",
     basic, reader::repair, &P::self_shaping},
    {"run_verification", "", "Stages",
     "Compute membranes and contact forces, and decide whether the design is valid.",
     0, physics, &P::run_verification},
    {"run_repair", "", "Stages",
     "Give pins more space before the layout, and repair weak contacts after verification.",
     0, reader::repair, &P::run_repair},
    {"run_settling", "", "Stages",
     "Let the tiles settle under their membranes, with friction, and report whether the shape "
     "holds.",
     keeps_layout, reader::settle, &P::run_settling},
  };
}
// clang-format on

// Short names of the switches of stages.
struct Alias {
  std::string_view alias, name;
};
constexpr Alias aliases[] = {
    {"verify", "run_verification"}, {"repair", "run_repair"}, {"settle", "run_settling"}};

}  // namespace

const std::vector<ParameterInfo>& parameter_table() {
  static const std::vector<ParameterInfo> table = make_table();
  return table;
}

const ParameterInfo* find_parameter(std::string_view name) {
  for (const Alias& other : aliases) {
    if (other.alias == name) name = other.name;
  }
  for (const ParameterInfo& info : parameter_table()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

}  // namespace curveups
