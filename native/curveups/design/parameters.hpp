// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of a design. The command line, the design file, the FreeCAD properties and the
// documentation read one table.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace curveups {

struct Parameters {
  // Target
  double scale = 1.0;
  bool flip = false;
  std::string skin = "outer";
  std::string faces;
  std::string open = "auto";
  double L = 7.0;
  double maximum_deviation = 0.5;
  double crease_angle = 180.0;
  std::string mend = "off";
  double mend_max = 2.0;
  std::string pieces = "1";  // "auto", or a number
  std::string joint = "none";
  // Tiles
  double H_body = 3.0;
  double H_pin = 1.0;
  // Layout
  double d_gap_min = 0.6;
  double p_min = 0.6;
  double p_floor = 0.3;
  double p_max = 3.0;
  double A_pin_min = 4.0;
  double A_pin_floor = 1.0;
  double tau = 3.0;
  // Bumps
  std::string bumps = "bumps";
  double bump_height = 0.25;
  double xy_compensation = 0.05;
  // Support
  std::string support = "soluble";
  std::string orientation = "front-up";
  // Anchors
  bool anchors = true;
  double anchor_radius = 4.0;
  // Files
  std::string printer = "polyjet";
  double mesh_deviation = 0.02;
  bool check_all = false;
  // Physics
  double shear_modulus_front = 0.72;
  double shear_modulus_back = 0.72;
  double thickness_front = 0.5;
  double thickness_back = 0.5;
  double elongation_at_break = 600.0;
  double glue_strength = 0.7;
  std::string membrane_model = "tension-field";
  double friction_coefficient = 0.5;
  double hold_tolerance = 0.0;
  double margin_mismatch = 10.0;
  double margin_friction = 0.3;
  double f_min_ratio = 0.1;
  std::string gravity = "off";
  std::string held_tiles;  // as listed_tiles reads them
  double density = 1.18;
  // Repair
  bool self_shaping = false;
  // Stages
  bool run_verification = true;
  bool run_repair = true;
  bool run_settling = true;
  std::string margin = "report";
  bool window = false;
  // No row of the table: largest edges of the coarser membrane mesh as a fraction of L (tests take
  // larger ones); half of it on the finer mesh.
  double mesh_size = 0.65;
};

// Parts of the engine that read a parameter, as a set of flags: their results are out of date when
// it changes. tiles: frustums, truncation and bounds of pins, which all parts but the target read.
namespace reader {
enum Part : unsigned {
  target = 1,
  tiles = 2,
  layout = 4,
  bodies = 8,
  support = 16,
  physics = 32,
  repair = 64,
  files = 128,
  check = 256,
  pieces = 512,
  settle = 1024
};
inline constexpr std::array<std::string_view, 11> names = {"target",  "tiles",   "layout", "bodies",
                                                           "support", "physics", "repair", "files",
                                                           "check",   "pieces",  "settle"};
}  // namespace reader

// Traits of a parameter, as a set of flags; the stages' switches have none.
namespace trait {
enum Trait : unsigned {
  basic = 1,        // shown first; the others on request
  keeps_layout = 2  // a change is followed without a new layout
};
}  // namespace trait

struct ParameterInfo {
  std::string_view name;
  std::string_view unit;     // "mm", "mm2", "" for pure numbers
  std::string_view group;    // heading in the property editor
  std::string_view meaning;  // one sentence, the tooltip
  unsigned traits;           // trait::Trait flags
  unsigned readers;          // reader::Part flags
  std::variant<double Parameters::*, bool Parameters::*, std::string Parameters::*> member;
  double minimum = 0;  // numbers: the closed range
  double maximum = 0;
  std::vector<std::string_view> choices = {};  // texts; none where `text` says what they are
  // The kind of a text without choices:
  //   tiles    a list for listed_tiles
  //   faces    numbers or names of faces of a CAD part, or ranges of them: "Face3, 7-9"; or nothing
  //   opening  the opening of a closed part: "auto", "largest", "none", or a plane: "z=0", "x>1.5"
  //   pieces   number of pieces that a target is divided into: "auto", or 1 to 24
  std::string_view text = {};
};

// Rows in the order in which they are shown.
const std::vector<ParameterInfo>& parameter_table();
// Null for an unknown name.
const ParameterInfo* find_parameter(std::string_view name);

using ParameterValue = std::variant<double, bool, std::string>;

// Sets one parameter by its name. Numbers may come as text. Throws InvalidInput, naming the
// parameter and its range: unknown name, value of another type, not finite, or out of range; leaves
// the parameters as they were.
void set_parameter(Parameters& parameters, std::string_view name, const ParameterValue& value);
ParameterValue get_parameter(const Parameters& parameters, std::string_view name);
bool operator==(const Parameters& a, const Parameters& b);

// Tiles of a list like "T00012, T00345" (the first tile is T00001), numbered from 0, ascending.
// Throws InvalidInput for anything else.
std::vector<int> listed_tiles(std::string_view text);

// Throws InvalidInput where single values are in range but contradict one another (p_min > p_max,
// a bump higher than half its diameter, ...).
void check_parameters(const Parameters& parameters);

}  // namespace curveups
