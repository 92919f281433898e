# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path from flat to shape on a page: a picture that moves, and the answers as a table."""

from __future__ import annotations

import base64
import json
from importlib.resources import files
from typing import Any, Mapping

import numpy as np

from ..stages.actuation import Actuation, moved
from .tables import table

# Of tiles where the piece comes to rest, by their numbers in frames.js: hue and saturation (%), and what they
# are.
_MARKS = {1: ((4, 75), "tiles of contacts that stay open"),
          2: ((285, 55), "tiles that wedge hardest without friction"), 3: ((330, 85), "both")}
_CANVAS = "width:100%;background:#fff;border:1px solid #e8e1d3;border-radius:.4rem;touch-action:none"


def front_corners(design: Any, rows: np.ndarray) -> np.ndarray:
    """M x 3 x 3: the tiles' front corners in a frame."""
    return moved(np.asarray(design.V)[np.asarray(design.F)], rows)


def moving_view(found: Actuation) -> str:
    """The frames, to be played, turned by dragging and stepped through; one a page. Corners are 16-bit
    numbers."""
    frames = found.frames
    corners = np.stack([front_corners(found.design, rows).reshape(-1, 3) for rows in frames])
    corners -= corners.mean(1, keepdims=True)  # the layout may lie far from the target
    size = max(float(np.linalg.norm(corners, axis=2).max()), 1e-9)  # it fits however it is turned
    whole = np.round(corners * (32767 / size)).astype("<i2")
    marks = tile_marks(found)
    data = base64.b64encode(whole.tobytes()).decode("ascii")
    script = files(__package__).joinpath("frames.js").read_text("utf-8")
    return (f'<canvas id="piece" width="1200" height="760" style="{_CANVAS}"></canvas>'
            f'<p><button id="play">Play</button> <input id="frame" type="range" min="0" '
            f'max="{len(frames) - 1}" value="0" style="width:70%"> <span id="at"></span></p>'
            f"<script>const FRAMES={len(frames)},DATA='{data}',"
            f"DOING={json.dumps(found.doing)},MARKS={json.dumps(marks)},"
            f"HUES={json.dumps({mark: hue for mark, (hue, _) in _MARKS.items()})},"
            f"TIMES={np.round(found.time, 6).tolist()},"
            f"ENERGIES={np.round(found.energy, 3).tolist()};\n{script}</script>{_legend(marks)}")


def tile_marks(found: Actuation) -> dict[int, list[int]]:
    """Of the frames in which the piece comes to rest, a number a tile (of _MARKS; 0: nothing to show). Tiles
    that wedge are those at the end of the path."""
    marks = {}
    for frame, end in found.ends.items():
        of_tile = np.zeros(len(found.design.F), int)
        of_tile[[tile for pair in end["open_contacts"] for tile in pair]] = 1
        if end is found.block:
            of_tile[found.wedged_tiles] += 2
        if of_tile.any():
            marks[frame] = of_tile.tolist()
    return marks


def _legend(marks: Mapping[int, list[int]]) -> str:
    """What colours of tiles mean, and in which frames they are shown."""
    if not marks:
        return ""
    seen = set().union(*marks.values())
    entries = "".join(f'<span style="color:hsl({hue[0]},{hue[1]}%,50%)">&#9632;</span> {what}, '
                      for mark, (hue, what) in _MARKS.items() if mark in seen or 3 in seen)
    frames = ", ".join(str(frame + 1) for frame in marks)
    return f'<p class="note">{entries}where the piece comes to rest: frame {frames}</p>'


def answers(block: Mapping[str, Any]) -> str:
    """What the block of report.json says, as a table."""
    rows: list[tuple[Any, ...]] = [
        ("It arrives by itself", block["arrives"]),
        ("Friction coefficient", block["friction_coefficient"]),
        ("Short of the shape that it keeps once it is there, mm", block["shortfall_mm"]),
        ("Tolerance (hold_tolerance), mm", block["tolerance_mm"]),
        ("Virtual scan: mean, largest, mm", [block["scan"]["mean_mm"], block["scan"]["max_mm"]])]
    if "sampled" in block:
        reach = block["reach_friction"]
        rows += [("Largest sampled friction at which it arrives", "none" if reach is None else reach),
                 ("Trap: without friction, flat and target end differently", block["trap"]),
                 ("Distance of these ends, mm", block["trap_distance_mm"])]
    return table(rows)


def released(block: Mapping[str, Any]) -> list[str]:
    """How hands released the piece, a row for each thing they did; nothing where they cut it out at once."""
    if "phases" not in block:
        return []
    rows = [(phase["phase"], phase["removed_n_mm"], phase["steps"],
             phase["shortfall_mm"] if phase["converged"] else "no rest", len(phase["open_contacts"]),
             phase["energy_n_mm"]) for phase in block["phases"]]
    return ["<h2>Released</h2>", table(rows, ("What hands do", "Energy cut off, N mm", "Steps",
                                              "Then short by, mm", "Open contacts", "Energy, N mm"))]


def changes_tried(block: Mapping[str, Any]) -> list[str]:
    """What would help, with the present design first; nothing where that was not asked."""
    tried = block.get("help", ())
    if not tried:
        return []
    rows = [("as it is", block["arrives"], block["shortfall_mm"], len(block["open_contacts"]), ""),
            *((one["what"].partition(": ")[0], "no answer" if one["arrives"] is None else one["arrives"],
               one.get("shortfall_mm"), len(one["open_contacts"]) if "open_contacts" in one else None,
               "no such design" if one["valid"] is None else one["valid"]) for one in tried)]
    return [table(rows, ("Change", "Arrives", "Short by, mm", "Open contacts", "Valid"))]
