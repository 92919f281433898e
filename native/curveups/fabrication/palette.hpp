// SPDX-License-Identifier: LGPL-2.1-or-later
// Colours of bodies in STEP and 3MF.
#pragma once

#include <array>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

// sRGB, 0 to 255: tiles blue, support sand, anchors brick (the engraved one marks the front).
struct Colour {
  unsigned char red, green, blue;
};

inline Colour body_colour(BodyKind kind) {
  switch (kind) {
    case BodyKind::tile:
      return {58, 110, 165};
    case BodyKind::support:
      return {222, 203, 164};
    case BodyKind::anchor:
      return {190, 92, 67};
  }
  return {128, 128, 128};
}

}  // namespace curveups
