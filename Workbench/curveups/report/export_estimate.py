# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimates how large an export becomes and how long it takes, within a factor of two."""

from __future__ import annotations

from typing import Any

from .exports import Choice

# Bytes a tile, measured on Half-Sphere and the saddle: of plain walls, and of bumps in two rows of three.
_STEP = {"tiles": (13_100, 4_600), "support": (14_200, 4_600), "anchors": (700, 0), "print": (28_400, 9_400),
         "actuated": (14_900, 0)}
# Of triangles the bumps' part grows as their number: inversely to the deviation, here 1 mm.
_TRIANGLES = {"stl": {"tiles": (1_700, 215.0), "support": (2_600, 215.0), "anchors": (530, 0.0)},
              "3mf": {"print": (1_200, 138.0)}}
_BUMPS = {"none": 0.0, "bumps": 1.0, "dimples": 2.7}
# Seconds: for a tile's solid and its check, and for a megabyte of each format, two cores.
_SOLID, _CHECK = 0.0004, 0.0045
_MEGABYTE = {"step": 0.015, "stl": 0.015, "3mf": 0.2}
_REPORT = (400_000, 1.0)


def estimate(tiles: int, parameters: Any, choice: Choice) -> tuple[int, float]:
    """Bytes and seconds of all chosen files of a design with so many tiles."""
    get = parameters.get
    bumps = _BUMPS[get("bumps")] * get("bump_count") * get("bump_rows") / 6
    deviation = get("mesh_deviation") if choice.deviation is None else choice.deviation
    size, seconds = 0.0, tiles * (_SOLID + _CHECK)
    for kind, ending in choice.files:
        if ending == "step":
            plain, rest = _STEP[kind]
        else:
            plain, share = _TRIANGLES[ending][kind]
            rest = share / max(deviation, 1e-4) if get("mesh_bumps") else 0.0
        bytes_ = tiles * (plain + bumps * rest)
        size += bytes_
        seconds += _MEGABYTE[ending] * bytes_ / 1e6
    if choice.reports:
        size, seconds = size + _REPORT[0], seconds + _REPORT[1]
    return round(size), seconds
