// SPDX-License-Identifier: LGPL-2.1-or-later
// Colours of bodies in STEP and 3MF.
#pragma once

#include <array>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// sRGB, 0 to 255: tiles blue, support sand, anchors brick.
struct Colour {
  unsigned char red, green, blue;
};

inline Colour body_colour(BodyKind kind) {
  constexpr Colour colours[] = {{58, 110, 165}, {222, 203, 164}, {190, 92, 67}};
  return colours[static_cast<int>(kind)];
}

}  // namespace curveups
