# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where pieces are sewn together (joint=holes), what is said of it, and what would help where there is no
room: a part of what `bodies` gives."""

from __future__ import annotations

import math
from typing import Any, Mapping, Sequence

from ..base.errors import tile_name


def joints_of(model: Any, parameters: Any) -> dict[str, Any]:
    """The block of report.json: edges between pieces, holes, their sizes (mm), the pairs of tiles (rows of
    F) without room and what leaves room everywhere; empty with joint=none. model: native PrintModel."""
    if parameters.get("joint") == "none":
        return {}
    joined, closed, holes, hole, area = model.joints
    return {"edges": len(joined) + len(closed), "holes": int(holes), "hole_mm": parameters.get("joint_hole"),
            "wall_mm": parameters.get("p_floor"), "without": [[int(a), int(b)] for a, b in closed],
            **({"possible": {"joint_hole": hole, "A_pin_floor": area}} if closed else {})}


def not_joined(joints: Mapping[str, Any], parameters: Any) -> Sequence[dict[str, Any]]:
    """Warnings: nothing to join, or edges without holes."""
    if not joints:
        return ()
    if not joints["edges"]:
        return ({"what": "joint=holes, but no two pieces have a border in common: there is nothing to join",
                 "remedy": "set pieces to auto or to 2 or more, or joint to none", "kind": "joint",
                 "tiles": []},)
    if not joints["without"]:
        return ()
    names = ", ".join(f"{tile_name(a)}-{tile_name(b)}" for a, b in joints["without"])
    return ({"what": f"{len(joints['without'])} of {joints['edges']} edges between pieces have no room for "
                     f"stitching holes: {names}",
             "remedy": _remedy(joints["possible"], parameters), "kind": "joint",
             "tiles": sorted({tile for pair in joints["without"] for tile in pair})},)


def _remedy(possible: Mapping[str, float], parameters: Any) -> str:
    # Rounded down, so that what is named does.
    hole, area = (math.floor(100 * possible[name]) / 100 for name in ("joint_hole", "A_pin_floor"))
    if hole >= parameters.get("joint_hole"):
        return "compute the layout with joint=holes, so that pins make room"
    options = [f"joint_hole to {hole:g}"] if hole > 0 else []
    options += [f"A_pin_floor to {area:g}"] if area > 0 else []
    other = "raise L or lower H_body"
    return f"set {' or '.join(options)}, so that pins can make room; or {other}" if options else other
