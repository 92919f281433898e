# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where pieces are sewn together (joint=holes), and what is said of it: a part of what `bodies` gives."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

from ..base.findings import Finding
from ..base.native import native


def joints_of(model: Any, parameters: Any) -> dict[str, Any]:
    """The block of report.json: edges between pieces, holes, their sizes (mm) and the pairs of tiles (rows of
    F) without room; empty with joint=none. model: native PrintModel."""
    if parameters.get("joint") == "none":
        return {}
    joined, closed, holes = model.joints
    return {"edges": len(joined) + len(closed), "holes": int(holes), "hole_mm": native.JOINT_HOLE,
            "wall_mm": parameters.get("p_floor"), "without": [[int(a), int(b)] for a, b in closed]}


def not_joined(joints: Mapping[str, Any], parameters: Any) -> Sequence[Finding]:
    """Warnings: nothing to join, or edges without holes."""
    if not joints:
        return ()
    if not joints["edges"]:
        return (Finding("joint.none"),)
    if not joints["without"]:
        return ()
    pairs = tuple((a, b) for a, b in joints["without"])
    return (Finding.about("joint", (tile for pair in pairs for tile in pair), closed=len(pairs),
                          edges=joints["edges"], pairs=pairs),)
