# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooths the remeshed target until tiles of this size are feasible, where mend is on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np

from ..base.errors import tile_list
from ..base.findings import Finding
from ..base.native import native
from .cut_request import mesh_edges
from .stage import Inputs, Job, Picture, Result, Row, Stage, digest

# Cuts leave tiles more room than contacts do, and are asked for on what this makes.
_NO_CUTS = np.zeros((0, 2), np.int32)


@dataclass(frozen=True)
class TargetSmoothing(Result):
    """V: N x 3, where the target's vertices are from now on."""

    V: np.ndarray
    asked: bool = False                   # whether mending was
    block: Optional[dict] = None          # of report.json, where mending was asked for
    warned: tuple[Finding, ...] = ()
    F: Optional[np.ndarray] = None        # M x 3, where anything is to be shown of it
    distance: Optional[np.ndarray] = None  # N, mm, of the vertices from what was given

    @property
    def content(self) -> str:
        return digest(self.V)

    def report(self) -> dict[str, Any]:
        return {} if self.block is None else {"mending": self.block}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("target smoothing", seconds),) if self.asked else ()

    def pictures(self) -> Sequence[Picture]:
        if self.distance is None:
            return ()
        return (Picture("Mending", "How far the mended target is from what was given, from both sides.",
                        "movement", {"V": self.V, "F": self.F, "values": self.distance}),)


def smooth_target(V: np.ndarray, F: np.ndarray, parameters: Any, job: Job) -> Any:
    """The native FairedSurface of a remeshed target."""
    return native.smooth_target(V, F, _NO_CUTS, _NO_CUTS, parameters.get("mend_max"), parameters, job)


def _run(inputs: Inputs, job: Job) -> TargetSmoothing:
    target, parameters = inputs["target"], inputs.parameters
    if parameters.get("mend") != "on":
        return TargetSmoothing(target.V)
    made = smooth_target(target.V, target.F, parameters, job)
    move = np.asarray(made.move, float)
    moved, largest = int((move > 0).sum()), float(move.max(initial=0.0))
    pairs, faces = mesh_edges(target.F)
    border = move[np.unique(pairs[faces == 1])]
    tiles = sorted({int(pin.tile) for pin in made.fixed})
    actions = list(target.actions)
    if moved:
        actions.append(f"{moved} vertices moved by up to {largest:.2g} mm, which gives {len(tiles)} tiles "
                       f"room ({tile_list(tiles)})")
    if border.any():
        actions.append(f"{int((border > 0).sum())} of these are of the border, which moved by up to "
                       f"{border.max():.2g} mm where tiles had no room otherwise")
    faired_by = native.surface_deviation(made.V, target.F, target.V, target.F, job)[-1] if moved else 0.0
    block = {"actions": actions, "moved_vertices": moved,
             "border_max_mm": float(border.max(initial=0.0)),
             "mean_mm": float(move[move > 0].mean()) if moved else 0.0, "max_mm": largest,
             "hausdorff_mm": max(target.mended_by, float(faired_by)), "tiles": tiles,
             "remaining": sorted({int(pin.tile) for pin in made.remaining})}
    tiles, most = block["remaining"], parameters.get("mend_max")
    found = [Finding.about("mending.remaining", tiles, at=tuple(tiles), most=most)] if tiles else []
    V = np.ascontiguousarray(made.V) if moved else target.V
    found += _far(V, target, most, job)
    shown = (target.F, native.distances(V, *target.given)) if actions else ()
    return TargetSmoothing(V, True, block, tuple(found), *shown)


def _far(V: np.ndarray, target: Any, most: float, job: Job) -> list[Finding]:
    """Whether the tiles' surface is farther from what was to be remeshed than mending may move it."""
    surface = target.source_V, target.source_F
    *_, hausdorff = native.surface_deviation(V, target.F, *surface, job)
    if hausdorff <= most:
        return []
    far = native.distances(V[target.F].mean(axis=1), *surface) > most
    return [Finding.about("mending.far", np.flatnonzero(far), distance=float(hausdorff), most=most)]


STAGE = Stage("target smoothing", ("target",), frozenset({"target", "tiles"}), _run,
              label="Mending", asked_by=("solve",), shown=True)
