// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters that hold a text without a list of choices: what the text may be, and what it means.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace curveups {

// Throws InvalidInput where `text` is none of this kind (ParameterInfo::text):
//   tiles    what listed_tiles reads
//   faces    numbers or names of faces of a CAD part, or ranges of them: "Face3, 7-9"; or nothing
//   opening  where a closed part is opened: "auto", "largest", "none", or a plane: "z=0", "x>1.5"
//   pieces   number of pieces that a target is divided into: "auto", or 1 to 24
void check_text(std::string_view kind, std::string_view text);
std::string text_remedy(std::string_view kind);

// The tiles of a list like "T00012, T00345" (the first tile is T00001), numbered from 0, ascending.
// Throws InvalidInput for anything else.
std::vector<int> listed_tiles(std::string_view text);

}  // namespace curveups
