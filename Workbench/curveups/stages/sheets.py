# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets of the membranes: cutting sizes, marks, and the loads of the ring that holds them stretched.

A sheet is held by rows of teeth around an open window, which is as large as the anchors' box and a margin.
The sheet has a grid of lines, as far apart as the teeth over tau: stretched rightly, each tooth meets a
crossing. Hands hold the sheet outside the outer teeth. The load on a side is the tension of a sheet stretched
alike in both directions times the window's length there.
"""

from __future__ import annotations

import math
from typing import Any, Sequence

from ..base.findings import Finding
from ..base.native import native
from .stage import Block, Inputs, Job, Stage

SIDES = ("front", "back")


def _load_anchors(inputs: Inputs, job: Job) -> Block:
    """Pull (N) and shear (MPa) on the glue of one anchor, front and back; empty without anchors.

    Before the surplus is cut off it pulls at the outline (paper, section 6.2) with the tension of a sheet
    that is stretched alike in both directions: of a neo-Hookean one T = G h (1 - tau^-6) N/mm, from the
    Cauchy stress G (tau^2 - tau^-4) on the thickness h / tau^2. An anchor takes that along its spacing, with
    the glue on one of its ends for each sheet."""
    get = inputs.parameters.get
    if not get("anchors"):
        return Block("anchors")
    tension = native.surplus_tension(inputs.parameters)
    pulls = [native.ANCHOR_SPACING * force for force in tension]
    shears = [pull / (math.pi * get("anchor_radius") ** 2) for pull in pulls]
    overload = Finding.about("anchor", pull=max(pulls), shear=max(shears), limit=get("glue_strength"))
    return Block("anchors", {"surplus_tension_n_per_mm": list(tension), "pull_n": pulls,
                             "glue_shear_mpa": shears},
                 (overload,) if max(shears) > get("glue_strength") else ())


ANCHORING = Stage("anchoring", (), frozenset({"layout", "support", "physics"}), _load_anchors,
                  on_stop=lambda stage, inputs: Block("anchors"),
                  label="Anchors", commands=("solve",))


TOOTH_PITCH = 15.0  # mm, from tooth to tooth of a stretching ring
TOOTH_ROWS = 2      # on each side of the window
MARGIN = 10.0       # mm, from the anchors' box to the window, stretched
GRIP = 20.0         # mm of sheet beyond the outer teeth, not stretched
CONTROL = 10.0      # mm, side of a control square, not stretched
ROUND = 5.0         # mm, to which cutting sizes are rounded up


def sheets(box: Sequence[float], parameters: Any) -> dict[str, Any]:
    """Block of report.json for a print with this box; lengths in mm, x and y of the print."""
    get = parameters.get
    tau = get("tau")
    window = [math.ceil((side + 2 * MARGIN) / TOOTH_PITCH) * TOOTH_PITCH for side in box]
    marked = [(side + 2 * TOOTH_ROWS * TOOTH_PITCH) / tau for side in window]
    return {"count": 2, "box_mm": list(box), "window_mm": window, "marked_mm": marked,
            "cut_mm": [math.ceil((side + 2 * GRIP) / ROUND) * ROUND for side in marked],
            "grip_mm": GRIP, "grid_mm": TOOTH_PITCH / tau, "tooth_pitch_mm": TOOTH_PITCH,
            "tooth_rows": TOOTH_ROWS, "control_square_mm": CONTROL,
            "control_square_stretched_mm": CONTROL * tau, "tau": tau,
            "thickness_mm": [get(f"thickness_{side}") for side in SIDES],
            # The tension along a side pulls the sides that end there: x by the window's height.
            "load_n": {side: [pull * window[1], pull * window[0]]
                       for side, pull in zip(SIDES, native.surplus_tension(parameters))}}


def _run(inputs: Inputs, job: Job) -> Block:
    model = inputs["bodies"].model
    if model is None:
        return Block("sheets")
    anchors = model.volumes["anchors"] > 0
    points, _, body = model.mesh("anchors" if anchors else "tiles")
    # Print and window are centred on the origin: the farthest point decides.
    x, y = (2 * float(abs(points[:, axis]).max()) for axis in (0, 1))
    return Block("sheets", {"anchors": int(body.max()) + 1 if anchors else 0,
                            **sheets((x, y), inputs.parameters)})


STAGE = Stage("sheets", ("bodies",), frozenset({"layout", "physics"}), _run,
              on_stop=lambda stage, inputs: Block("sheets"), label="Sheets of latex", commands=("print",))
