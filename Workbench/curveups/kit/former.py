# SPDX-License-Identifier: LGPL-2.1-or-later
"""The former as a body. It draws nothing, so who asks for it does not wait for matplotlib."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from .kit import Kit
from .underside import Underside

GAP = 6.0  # mm between formers


def make(kit: Kit) -> bytes:
    """A closed body a piece as binary STL."""
    return former_stl(kit.undersides)


def former_stl(undersides: Sequence[Underside]) -> bytes:
    """Bodies side by side."""
    sizes = [under.size[0] + GAP for under in undersides]
    corners = np.concatenate([under.facets() + (float(sum(sizes[:number])), 0, 0)
                              for number, under in enumerate(undersides)])
    rows = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    rows["corners"] = corners
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    rows["normal"] = normals / np.linalg.norm(normals, axis=1)[:, None]
    return b"CurveUps former".ljust(80) + np.uint32(len(rows)).tobytes() + rows.tobytes()
