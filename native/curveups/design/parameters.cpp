// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "curveups/core/errors.hpp"
#include "curveups/design/membrane_models.hpp"
#include "curveups/design/support_kinds.hpp"

namespace curveups {
namespace {

using P = Parameters;

constexpr double least_wall = 0.1;  // mm, around joint holes: solids stay far from degenerate

#define CURVEUPS_CHOICE(function, name, ...) name,

// clang-format off
std::vector<ParameterInfo> make_table() {
  using namespace reader;
  using namespace trait;
  return {
    {"scale", "", "Target",
     "Multiply the coordinates of a file without units by this factor (1000 for metres).",
     basic, target, &P::scale, 1e-6, 1e6},
    {"fit", "mm", "Target",
     "Scale the target until the longest side of its bounding box has this length. 0 leaves "
     "its size to scale.",
     basic, target, &P::fit, 0, 1e5},
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
    {"fidelity", "mm", "Target", "L=auto keeps the tiles within this distance of the target.",
     0, target, &P::fidelity, 1e-3, 100},
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
    {"mend_border", "", "Target",
     "Let mending move the border of the target where tiles have too little space otherwise.",
     0, target, &P::mend_border},
    {"pieces", "", "Target",
     "Number of pieces that the target is divided into (1 to 24). auto finds the smallest "
     "number that lies flat.",
     basic, pieces, &P::pieces, 0, 0, {}, "pieces"},
    {"joint", "", "Target",
     "Choose how pieces are joined after printing: holes gives the tiles along their borders "
     "stitching holes.",
     0, tiles, &P::joint, 0, 0, {"none", "holes"}},
    {"joint_hole", "mm", "Target",
     "Diameter of a stitching hole. Pins leave space for it, and p_floor of material stays "
     "around it.",
     0, tiles, &P::joint_hole, 0.2, 10},
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
    {"A_pin_min", "mm2", "Layout", "Least area of a pin's top. It makes the glue hold.",
     basic, tiles, &P::A_pin_min, 0, 1000},
    {"A_pin_floor", "mm2", "Layout", "A pin with a smaller area makes the design invalid.",
     0, tiles, &P::A_pin_floor, 0, 1000},
    {"pin_clearance", "mm", "Layout",
     "Distance that pins keep from facing pins and from truncation planes at sharp folds.",
     0, tiles, &P::pin_clearance, 0, 5},
    {"tau", "", "Layout",
     "Stretch ratio of the membranes when they are glued. 3 gives nine times the area.",
     basic, layout | physics, &P::tau, 1.05, 8},
    {"w_a", "", "Layout",
     "Weight of the alignment energy, which puts facing edges opposite each other.",
     0, layout, &P::w_a, 0, 1e6},
    {"w_p", "", "Layout", "Weight of the packing energy, which draws facing edges together.",
     0, layout, &P::w_p, 0, 1e6},
    {"w_s", "", "Layout",
     "Weight of the spring energy, which keeps the membranes well and evenly stretched.",
     0, layout, &P::w_s, 0, 1e6},
    {"bumps", "", "Bumps",
     "Choose what keeps contacts from sliding: bumps, dimples (bumps that snap into hollows) "
     "or nothing (none).",
     basic | keeps_layout, tiles, &P::bumps, 0, 0, {"bumps", "dimples", "none"}},
    {"bump_height", "mm", "Bumps", "Height of a friction bump above its wall.",
     basic | keeps_layout, tiles, &P::bump_height, 0.02, 5},
    {"bump_diameter", "mm", "Bumps", "Diameter of a friction bump at its wall.",
     keeps_layout, bodies, &P::bump_diameter, 0.1, 10},
    {"bump_count", "", "Bumps", "Number of bumps on an interface. Its two tiles share them.",
     keeps_layout, bodies, &P::bump_count, 3, 40},
    {"bump_rows", "", "Bumps", "Number of rows of bumps on an interface.",
     keeps_layout, bodies, &P::bump_rows, 2, 10},
    {"bump_recess", "", "Bumps",
     "Move walls with bumps back by half the bump height. This keeps the actuated shape from "
     "swelling.",
     keeps_layout, tiles, &P::bump_recess},
    {"dimple_clearance", "mm", "Bumps", "Clearance between a bump and its dimple.",
     keeps_layout, bodies, &P::dimple_clearance, 0, 2},
    {"wall_growth", "mm", "Bumps",
     "Move each wall that meets another one without bumps back by this. It makes up for the "
     "growth of printed walls (XY compensation).",
     keeps_layout, tiles, &P::wall_growth, 0, 1},
    {"support", "", "Support",
     "Choose what holds the layout together after printing: a soluble slab, breakaway bridges "
     "or nothing (none).",
     basic | keeps_layout, layout | support, &P::support, 0, 0,
     {CURVEUPS_SUPPORT_KINDS(CURVEUPS_CHOICE)}},
    {"orientation", "", "Support",
     "Choose which side faces up in the print. With front-down, breakaway bridges span "
     "between walls that stand already.",
     basic | keeps_layout, support, &P::orientation, 0, 0, {"front-up", "front-down"}},
    {"support_drop", "mm", "Support",
     "Distance from the front pin tops down to the slab. It keeps the glue on the pins away "
     "from the slab.",
     keeps_layout, support, &P::support_drop, 0, 50},
    {"support_margin", "mm", "Support", "Width of the slab around tiles and anchors.",
     keeps_layout, layout | support, &P::support_margin, 0.2, 50},
    {"bridge_width", "mm", "Support", "Width of a breakaway bridge.",
     keeps_layout, support, &P::bridge_width, 0.1, 20},
    {"bridge_thickness", "mm", "Support", "Thickness of a breakaway bridge.",
     keeps_layout, support, &P::bridge_thickness, 0.1, 20},
    {"bridge_notch", "mm", "Support", "Half the depth of the notches at which a bridge breaks.",
     keeps_layout, support, &P::bridge_notch, 0, 10},
    {"bridge_depth", "mm", "Support", "Depth to which a bridge enters each body.",
     keeps_layout, support, &P::bridge_depth, 0, 5},
    {"anchors", "", "Anchors",
     "Add cylinders around the layout that carry the pull of the surplus membrane.",
     basic | keeps_layout, layout | support, &P::anchors},
    {"anchor_radius", "mm", "Anchors", "Radius of an anchor.",
     keeps_layout, layout | support, &P::anchor_radius, 0.5, 100},
    {"anchor_spacing", "mm", "Anchors", "Distance between the axes of neighbouring anchors.",
     keeps_layout, support, &P::anchor_spacing, 1, 500},
    {"anchor_distance", "mm", "Anchors",
     "Distance from the outline of the layout to the anchors.",
     keeps_layout, layout | support, &P::anchor_distance, 0.2, 200},
    {"engrave", "", "Anchors",
     "Engrave name, piece, version and side on a tab beside one anchor of each piece.",
     keeps_layout, support, &P::engrave},
    {"engrave_depth", "mm", "Anchors", "Depth of the engraving.",
     keeps_layout, support, &P::engrave_depth, 0.05, 10},
    {"printer", "", "Files", "Compare the print with the bed, gaps and features of this printer.",
     basic | keeps_layout, check, &P::printer, 0, 0, {"polyjet", "resin", "fdm"}},
    {"mesh_deviation", "mm", "Files",
     "Largest distance of STL and 3MF facets from the curved surfaces (chord error).",
     basic | keeps_layout, files, &P::mesh_deviation, 1e-4, 1},
    {"mesh_bumps", "", "Files", "Include the bumps in STL and 3MF files.",
     keeps_layout, files, &P::mesh_bumps},
    {"step_structure", "", "Files",
     "Write STEP files as an assembly with one part per body, or as one part with one solid "
     "per body.",
     keeps_layout, files, &P::step_structure, 0, 0, {"assembly", "one-part"}},
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
     "Shear stress that the glue between membranes and print withstands. The report compares "
     "pins and anchors with it.",
     keeps_layout, physics, &P::glue_strength, 1e-3, 100},
    {"membrane_model", "", "Physics",
     "Choose the energy of the membranes: tension-field (they wrinkle where squeezed) or "
     "plain neo-hookean.",
     keeps_layout, physics, &P::membrane_model, 0, 0, {CURVEUPS_MEMBRANE_MODELS(CURVEUPS_CHOICE)}},
    {"mesh_size", "", "Physics",
     "Size of the largest triangles of the coarser membrane mesh, as a fraction of L. Those "
     "of the finer mesh have half of it.",
     keeps_layout, physics, &P::mesh_size, 0.05, 2},
    {"friction_coefficient", "", "Physics",
     "Coefficient of Coulomb friction between tiles, also at bumps.",
     basic | keeps_layout, physics, &P::friction_coefficient, 0.01, 10},
    {"tile_modulus", "MPa", "Physics",
     "Young's modulus of the tiles' material. It says how far walls and bumps give way where "
     "tiles settle.",
     keeps_layout, reader::settle, &P::tile_modulus, 10, 1e6},
    {"hold_tolerance", "mm", "Physics",
     "The shape holds where friction lets it drift by this at most, in the mean. 0 stands for "
     "1 % of L.",
     keeps_layout, reader::settle, &P::hold_tolerance, 0, 100},
    {"margin", "", "Physics",
     "Choose what a design must bear beyond its own values: nothing (off), margin_mismatch and "
     "margin_friction where it can (aim), or these in any case (require).",
     keeps_layout, reader::settle, &P::margin, 0, 0, {"off", "aim", "require"}},
    {"margin_mismatch", "%", "Physics",
     "How much harder than the other either membrane may pull within the margin.",
     keeps_layout, reader::settle, &P::margin_mismatch, 0, 90},
    {"margin_friction", "", "Physics",
     "Least coefficient of friction within the margin.",
     keeps_layout, reader::settle, &P::margin_friction, 0.01, 10},
    {"window", "", "Physics",
     "Find how far membranes, friction, glue and the print's growth may change, each alone, until "
     "the shape no longer holds.",
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
    {"gravity_x", "", "Physics", "x component of the direction of gravity.",
     keeps_layout, physics, &P::gravity_x, -1, 1},
    {"gravity_y", "", "Physics", "y component of the direction of gravity.",
     keeps_layout, physics, &P::gravity_y, -1, 1},
    {"gravity_z", "", "Physics", "z component of the direction of gravity.",
     keeps_layout, physics, &P::gravity_z, -1, 1},
    {"move_vertices", "", "Repair",
     "Let repair move vertices of the actuated surface slightly where poses and pins alone "
     "don't suffice.",
     0, reader::repair, &P::move_vertices},
    {"verify", "", "Stages",
     "Compute membranes and contact forces, and decide whether the design is valid.",
     0, physics, &P::verify},
    {"repair", "", "Stages",
     "Give pins more space before the layout, and repair weak contacts after verification.",
     0, reader::repair, &P::repair},
    {"recheck", "", "Stages",
     "Verify a second time on membrane meshes of half the size (mesh refinement check).",
     0, reader::recheck, &P::recheck},
    {"settle", "", "Stages",
     "Let the tiles settle under their membranes, with friction, and report whether the shape "
     "holds.",
     keeps_layout, reader::settle, &P::settle},
  };
}
// clang-format on

// Words of the field for parameters that files and documents know by names of our own. Whoever
// looks for a parameter by its name may use either.
struct Alias {
  std::string_view alias, name;
};
constexpr Alias aliases[] = {{"maximum_deviation", "fidelity"},
                             {"mesh_refinement_check", "recheck"},
                             {"xy_compensation", "wall_growth"}};

const ParameterInfo& find(std::string_view name) {
  if (const ParameterInfo* info = find_parameter(name)) return *info;
  throw InvalidInput("unknown parameter '" + std::string(name) + "'",
                     "list them with 'curveups parameters'");
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string shown(const ParameterValue& value) {
  if (const double* x = std::get_if<double>(&value)) return number(*x);
  if (const bool* b = std::get_if<bool>(&value)) return *b ? "on" : "off";
  return "'" + std::get<std::string>(value) + "'";
}

[[noreturn]] void refuse(const ParameterInfo& info, const ParameterValue& value,
                         const std::string& remedy) {
  throw InvalidInput("parameter " + std::string(info.name) + " can't be " + shown(value), remedy);
}

double to_number(const ParameterInfo& info, const ParameterValue& value) {
  const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
  const std::string range =
      "give a number from " + number(info.minimum) + " to " + number(info.maximum) + unit;
  double x = 0;
  if (const double* given = std::get_if<double>(&value)) {
    x = *given;
  } else if (const std::string* text = std::get_if<std::string>(&value)) {
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), x);
    if (error != std::errc() || end != text->data() + text->size()) refuse(info, value, range);
  } else {
    refuse(info, value, range);
  }
  if (!std::isfinite(x) || x < info.minimum || x > info.maximum) refuse(info, value, range);
  return x;
}

bool to_switch(const ParameterInfo& info, const ParameterValue& value) {
  if (const bool* b = std::get_if<bool>(&value)) return *b;
  if (const double* x = std::get_if<double>(&value)) {
    if (*x == 0 || *x == 1) return *x == 1;
  } else {
    const std::string& text = std::get<std::string>(value);
    for (const char* yes : {"on", "true", "yes", "1"}) {
      if (text == yes) return true;
    }
    for (const char* no : {"off", "false", "no", "0"}) {
      if (text == no) return false;
    }
  }
  refuse(info, value, "give on or off");
}

std::string text_remedy(std::string_view kind) {
  if (kind == "faces") return "name faces as FreeCAD does, from 1: Face3,Face7-9";
  if (kind == "opening") return "give auto, largest, none, or a plane as z=0, z>0 or x<12.5";
  if (kind == "pieces") return "give auto, or a whole number from 1 to 24";
  return "name tiles as reports do: T00012,T00345";
}

void check_text(std::string_view kind, const std::string& text) {
  if (kind == "faces") {
    check_faces(text);
  } else if (kind == "opening") {
    check_opening(text);
  } else if (kind == "pieces") {
    check_pieces(text);
  } else {
    listed_tiles(text);
  }
}

// Of "Face12" or "12"; 0 where it is none.
int face_number(std::string_view word) {
  if (word.substr(0, 4) == "Face") word.remove_prefix(4);
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() ? number : 0;
}

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

const std::vector<std::string_view>& retired_parameters() {
  static const std::vector<std::string_view> names = {"tightness", "w_c", "w_pa", "w_tight"};
  return names;
}

bool is_retired(std::string_view name) {
  const auto& names = retired_parameters();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<int> listed_tiles(std::string_view text) {
  std::vector<int> tiles;
  for (std::size_t begin = 0; begin < text.size();) {
    if (text[begin] == ' ' || text[begin] == ',') {
      ++begin;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
    const std::string_view name = text.substr(begin, end - begin);
    int number = 0;
    const auto [stop, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (name.size() < 2 || name[0] != 'T' || error != std::errc() ||
        stop != name.data() + name.size() || number < 1) {
      throw InvalidInput("'" + std::string(name) + "' is no tile",
                         "name tiles as reports do: T00012,T00345");
    }
    tiles.push_back(number - 1);
    begin = end;
  }
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

void check_faces(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size();) {
    if (text[begin] == ' ' || text[begin] == ',') {
      ++begin;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    const std::size_t dash = word.find('-');
    const int first = face_number(word.substr(0, dash));
    const int last = dash == word.npos ? first : face_number(word.substr(dash + 1));
    if (first < 1 || last < first) {
      throw InvalidInput("'" + std::string(word) + "' is no face", text_remedy("faces"));
    }
    begin = end;
  }
}

void check_opening(std::string_view text) {
  if (text == "auto" || text == "largest" || text == "none") return;
  double place = 0;
  if (text.size() > 2 && std::string_view("xyz").find(text[0]) != std::string_view::npos &&
      std::string_view("=<>").find(text[1]) != std::string_view::npos) {
    const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), place);
    if (error == std::errc() && end == text.data() + text.size() && std::isfinite(place)) return;
  }
  throw InvalidInput("'" + std::string(text) + "' is no opening", text_remedy("opening"));
}

void check_pieces(std::string_view text) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (text == "auto" || (whole && text[0] != '0' && count >= 1 && count <= 24)) return;
  throw InvalidInput("'" + std::string(text) + "' is no number of pieces", text_remedy("pieces"));
}

void set_parameter(Parameters& parameters, std::string_view name, const ParameterValue& value) {
  if (is_retired(name)) return;
  const ParameterInfo& info = find(name);
  if (const auto* member = std::get_if<double P::*>(&info.member)) {
    parameters.*(*member) = to_number(info, value);
  } else if (const auto* whole = std::get_if<int P::*>(&info.member)) {
    const double x = to_number(info, value);
    if (x != std::floor(x)) {
      refuse(info, value,
             "give a whole number from " + number(info.minimum) + " to " + number(info.maximum));
    }
    parameters.*(*whole) = static_cast<int>(x);
  } else if (const auto* flag = std::get_if<bool P::*>(&info.member)) {
    parameters.*(*flag) = to_switch(info, value);
  } else if (info.choices.empty()) {
    const double* x = std::get_if<double>(&value);
    const std::string* given = std::get_if<std::string>(&value);
    if (!given && !(x && info.text == "pieces")) refuse(info, value, text_remedy(info.text));
    const std::string text = given ? *given : number(*x);
    check_text(info.text, text);
    parameters.*std::get<std::string P::*>(info.member) = text;
  } else {
    std::string choices;
    for (std::string_view choice : info.choices) {
      choices += (choices.empty() ? "" : ", ") + std::string(choice);
    }
    static const std::string off = "off";  // what "ask" of earlier versions did to the design
    const std::string* text = std::get_if<std::string>(&value);
    if (text && name == "mend" && *text == "ask") text = &off;
    if (!text || std::find(info.choices.begin(), info.choices.end(), *text) == info.choices.end()) {
      refuse(info, value, "give one of " + choices);
    }
    parameters.*std::get<std::string P::*>(info.member) = *text;
  }
}

ParameterValue get_parameter(const Parameters& parameters, std::string_view name) {
  return std::visit(
      [&](auto member) {
        using Value = std::decay_t<decltype(parameters.*member)>;
        if constexpr (std::is_same_v<Value, int>) {
          return ParameterValue(static_cast<double>(parameters.*member));
        } else {
          return ParameterValue(parameters.*member);
        }
      },
      find(name).member);
}

bool operator==(const Parameters& a, const Parameters& b) {
  const auto& table = parameter_table();
  return std::all_of(table.begin(), table.end(), [&](const ParameterInfo& info) {
    return std::visit([&](auto member) { return a.*member == b.*member; }, info.member);
  });
}

void check_parameters(const Parameters& p) {
  if (p.p_min > p.p_max) {
    throw InvalidInput(
        "p_min (" + number(p.p_min) + " mm) is larger than p_max (" + number(p.p_max) + " mm)",
        "lower p_min or raise p_max");
  }
  if (p.A_pin_floor > p.A_pin_min) {
    throw InvalidInput("A_pin_floor (" + number(p.A_pin_floor) +
                           " mm2) is larger than A_pin_min (" + number(p.A_pin_min) + " mm2)",
                       "lower A_pin_floor or raise A_pin_min");
  }
  if (p.bumps != "none" && p.bump_height > 0.5 * p.bump_diameter) {
    throw InvalidInput("bump_height (" + number(p.bump_height) +
                           " mm) is more than half of bump_diameter (" + number(p.bump_diameter) +
                           " mm)",
                       "lower bump_height or raise bump_diameter");
  }
  if (p.bumps == "bumps" && p.bump_height >= 2 * p.d_gap_min) {
    throw InvalidInput("bump_height (" + number(p.bump_height) +
                           " mm) does not fit into the flat gap of d_gap_min (" +
                           number(p.d_gap_min) + " mm)",
                       "lower bump_height or raise d_gap_min");
  }
  if (p.bumps != "none" && p.bump_rows > p.bump_count) {
    throw InvalidInput("bump_rows (" + std::to_string(p.bump_rows) + ") is more than bump_count (" +
                           std::to_string(p.bump_count) + ")",
                       "lower bump_rows or raise bump_count");
  }
  if (p.gravity != "off" && p.gravity_x == 0 && p.gravity_y == 0 && p.gravity_z == 0) {
    throw InvalidInput("gravity has no direction: gravity_x, gravity_y and gravity_z are all 0",
                       "give a direction, or set gravity to off");
  }
  if (p.support == "breakaway" && 2 * p.bridge_notch >= p.bridge_thickness) {
    throw InvalidInput("bridge_notch (" + number(p.bridge_notch) + " mm) cuts a bridge of " +
                           number(p.bridge_thickness) + " mm through",
                       "lower bridge_notch or raise bridge_thickness");
  }
  if (p.support == "soluble" && p.support_drop >= 2 * p.H_pin + p.H_body) {
    throw InvalidInput(
        "support_drop (" + number(p.support_drop) + " mm) leaves no support",
        "give less than the whole height, " + number(2 * p.H_pin + p.H_body) + " mm");
  }
  if (p.support == "soluble" && p.orientation == "front-down") {
    throw InvalidInput(
        "a soluble slab can't be printed front side down: it lies on the bed beside "
        "the back pins",
        "set orientation to front-up, or support to breakaway");
  }
  if (p.joint == "holes" && p.p_floor < least_wall) {
    throw InvalidInput(
        "p_floor (" + number(p.p_floor) + " mm) leaves no wall around joint holes",
        "raise p_floor to " + number(least_wall) + " mm or more, or set joint to none");
  }
  if (p.joint == "holes" && p.support == "breakaway" && p.bridge_depth >= p.p_floor) {
    throw InvalidInput("bridges enter tiles by " + number(p.bridge_depth) +
                           " mm (bridge_depth): into joint holes, behind " + number(p.p_floor) +
                           " mm of wall (p_floor)",
                       "lower bridge_depth or raise p_floor");
  }
  if (p.anchors && p.anchor_spacing < 2 * p.anchor_radius + p.d_gap_min) {
    throw InvalidInput("anchors of radius " + number(p.anchor_radius) +
                           " mm overlap at a spacing of " + number(p.anchor_spacing) + " mm",
                       "raise anchor_spacing or lower anchor_radius");
  }
  if (p.anchors && p.engrave && p.engrave_depth >= p.H_pin + p.H_body) {
    throw InvalidInput("engrave_depth (" + number(p.engrave_depth) + " mm) pierces the label",
                       "give less than its thickness, " + number(p.H_pin + p.H_body) + " mm");
  }
}

}  // namespace curveups
