# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smoothing of the target. Mending moves vertices until tiles of this size are feasible; feasibility
smoothing moves some a little, before the layout, where dihedral angles leave pins too little space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Optional, Sequence

import numpy as np

from ..base.errors import tile_list
from ..base.findings import Finding, settle
from ..base.native import native
from .cut_request import mesh_edges
from .stage import Inputs, Job, Picture, Result, Row, Stage, digest, moved_vertices

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


def _smooth_target(inputs: Inputs, job: Job) -> TargetSmoothing:
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


TARGET = Stage("target smoothing", ("target",), frozenset({"target", "tiles"}), _smooth_target,
               label="Mending", asked_by=("solve",), shown=True)


_SAME_THICKNESS = 0.05  # of a wall and the tiles that take its place, relative
# Sides without a pin, as a share of all, from which none is given room: what one tile gains its neighbours
# lose. Vertices of thousands of such sides would move for up to half a minute each time a size is tried.
MOST_SHORT = 0.25


@dataclass(frozen=True)
class PinSmoothing(Result):
    """V: N x 3, where the tiles' vertices are from now on."""

    V: np.ndarray
    warned: tuple[Finding, ...]
    asked: bool = False
    moved: Optional[dict] = None        # the block of report.json, where vertices moved

    @property
    def content(self) -> str:
        return digest(self.V)

    def report(self) -> dict[str, Any]:
        return {} if self.moved is None else {"pin_smoothing": self.moved}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("pin smoothing", seconds),) if self.asked else ()


def smooth_for_pins(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any,
                    job: Job) -> tuple[np.ndarray, Optional[dict]]:
    """The vertices as they are from now on, and the block of report.json where some moved: none where
    nothing is to be done or the parameters do not ask for it."""
    if not parameters.get("run_repair") or mostly_short(V, F, edges, parameters):
        return V, None
    smoothed = native.smooth_for_pins(V, F, edges, parameters, job)
    if not smoothed.reached:
        return V, None
    return smoothed.V, {"largest_move_mm": smoothed.largest_move_mm,
                        "pin_sides": [{"tile": int(pin.tile), "side": pin.side, "area_before_mm2": pin.area}
                                      for pin in smoothed.reached],
                        "remaining": len(smoothed.remaining),
                        "moved_vertices": moved_vertices(V, smoothed.V, F)}


def mostly_short(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any) -> bool:
    """Whether so many pins have no room that moving vertices is of no use."""
    found = native.target_figures(V, F, edges, parameters)
    return bool(found.shaped
                and (np.asarray(found.pin_area) < parameters.get("A_pin_floor")).mean() > MOST_SHORT)


def _run(inputs: Inputs, job: Job) -> PinSmoothing:
    target, edges, parameters = inputs["target"], inputs["cuts"].edges, inputs.parameters
    V, moved = smooth_for_pins(inputs["target smoothing"].V, target.F, edges, parameters, job)
    found = settle(native.check_target(V, target.F, edges, parameters), inputs.where)
    return PinSmoothing(V, (*found, *_other_thickness(target.wall, parameters)),
                        bool(parameters.get("run_repair")), moved)


def _other_thickness(wall: Optional[float], parameters: Any) -> Iterator[Finding]:
    H_body = parameters.get("H_body")
    if wall is not None and abs(wall - H_body) > _SAME_THICKNESS * wall:
        yield Finding.about("wall", wall=wall, H_body=H_body)


STAGE = Stage("pin smoothing", ("target", "target smoothing", "cuts"), frozenset({"tiles", "repair"}), _run,
              label="Feasibility smoothing", asked_by=("solve",), shown=True)
