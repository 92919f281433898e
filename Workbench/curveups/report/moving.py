# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path from flat to shape on a page: a picture that moves, and its states as a table."""

from __future__ import annotations

import base64
import json
from importlib.resources import files
from typing import Any, Mapping

import numpy as np

from ..stages.actuation import Actuation, moved, states
from .data import table

OPEN = (4, 75)  # hue and saturation (%) of tiles whose contacts stay open
WORDS = {"by_itself": "released", "shaken": "shaken", "pressed": "pressed and let go"}
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
    data = base64.b64encode(whole.tobytes()).decode("ascii")
    script = files(__package__).joinpath("frames.js").read_text("utf-8")
    marks = open_tiles(found)
    return (f'<canvas id="piece" width="1200" height="760" style="{_CANVAS}"></canvas>'
            f'<p><button id="play">Play</button> <input id="frame" type="range" min="0" '
            f'max="{len(frames) - 1}" value="0" style="width:70%"> <span id="at"></span></p>'
            f"<script>const FRAMES={len(frames)},DATA='{data}',"
            f"DOING={json.dumps([WORDS[load] for load in found.loads])},MARKS={json.dumps(marks)},"
            f"HUE={json.dumps(OPEN)},"
            f"TIMES={np.round(found.time, 6).tolist()},"
            f"ENERGIES={np.round(found.energy, 3).tolist()};\n{script}</script>{_legend(marks)}")


def open_tiles(found: Actuation) -> dict[int, list[bool]]:
    """Tiles of open contacts in the frames in which the piece comes to rest, where there are some."""
    marks = {}
    for state in found.states.values():
        of_tile = np.zeros(len(found.design.F), bool)
        of_tile[[tile for pair in state["open_contacts"] for tile in pair]] = True
        if state["converged"] and of_tile.any():
            marks[state["last_frame"]] = of_tile.tolist()
    return marks


def _legend(marks: Mapping[int, list[bool]]) -> str:
    """Meaning of the colour, and the frames that have it."""
    if not marks:
        return ""
    frames = ", ".join(str(frame + 1) for frame in marks)
    return (f'<p class="note"><span style="color:hsl({OPEN[0]},{OPEN[1]}%,50%)">&#9632;</span> tiles of '
            f"contacts that stay open, where the piece comes to rest: frame {frames}</p>")


def states_table(block: Mapping[str, Any]) -> str:
    """States of a block of report.json, a row each."""
    rows = [(WORDS[name] if state["converged"] else f"{WORDS[name]}: no rest",
             *(state[key] for key in ("mean_mm", "rms_mm", "p95_mm", "max_mm", "hausdorff_mm")),
             len(state["open_contacts"]), state["energy_n_mm"]) for name, state in states(block).items()]
    return table(rows, ("State", "Mean, mm", "RMS, mm", "95 %, mm", "Largest, mm", "Hausdorff, mm",
                        f"Open of {block['contacts']} contacts", "Energy, N mm"))
