# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of triangle meshes."""

from __future__ import annotations

import numpy as np


def sides_of_edges(F: np.ndarray) -> dict[tuple[int, int], list[tuple[int, int]]]:
    """The tiles at each edge (its vertices, the lower first), with which side (0 to 2) of theirs it is."""
    sides: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for tile, face in enumerate(np.asarray(F).tolist()):
        for k in range(3):
            a, b = face[k], face[(k + 1) % 3]
            sides.setdefault((min(a, b), max(a, b)), []).append((tile, k))
    return sides
