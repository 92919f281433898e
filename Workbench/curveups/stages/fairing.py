# SPDX-License-Identifier: LGPL-2.1-or-later
"""The remeshed target faired until tiles of this size can be, where mending is asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np

from ..errors import tile_list
from ..native import native
from .stage import Inputs, Job, Result, Row, Stage, digest

# Cuts leave tiles more room than contacts do, and are asked for on what this makes; no line has to stay.
NONE = np.zeros((0, 2), np.int32)


@dataclass(frozen=True)
class Fairing(Result):
    """V: N x 3, where the target's vertices are from now on."""

    V: np.ndarray
    asked: str                          # off, ask, on
    block: Optional[dict] = None        # of report.json, where mending was asked for
    found: tuple[dict, ...] = ()        # warnings

    @property
    def content(self) -> str:
        return digest(self.V)

    def report(self) -> dict[str, Any]:
        return {} if self.block is None else {"mending": self.block}

    def warnings(self) -> Sequence[dict]:
        return self.found

    def rows(self, seconds: float) -> Sequence[Row]:
        return () if self.asked == "off" else (Row("fairing", seconds),)


def _run(inputs: Inputs, job: Job) -> Fairing:
    target, parameters = inputs["target"], inputs.parameters
    asked = parameters.get("mend")
    if asked == "off":
        return Fairing(target.V, asked)
    made = native.fair_surface(target.V, target.F, NONE, NONE, parameters.get("mend_max"), parameters, job)
    move = np.asarray(made.move, float)
    moved, largest = int((move > 0).sum()), float(move.max(initial=0.0))
    tiles = sorted({int(pin.tile) for pin in made.fixed})
    would = list(target.actions)
    if moved:
        would.append(f"{moved} vertices moved by up to {largest:.2g} mm, which gives {len(tiles)} tiles room "
                     f"({tile_list(tiles)})")
    block = {"actions": would, "applied": asked == "on", "moved_vertices": moved,
             "mean_mm": float(move[move > 0].mean()) if moved else 0.0, "max_mm": largest,
             "hausdorff_mm": max(target.mended_by, largest), "tiles": tiles,
             "remaining": sorted({int(pin.tile) for pin in made.remaining})}
    if asked == "on":
        return Fairing(np.ascontiguousarray(made.V) if moved else target.V, asked, block)
    found = [{"what": f"mend=on would mend the target: {', '.join(would)}", "kind": "mending",
              "remedy": "set mend=on", "tiles": tiles}] if would else []
    return Fairing(target.V, asked, block, tuple(found))


STAGE = Stage("fairing", ("target",), frozenset({"target", "tiles"}), _run)
