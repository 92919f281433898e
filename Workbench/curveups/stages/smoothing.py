# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smoothing of the target. Mending moves vertices until tiles of this size are feasible; feasibility
smoothing moves some a little, before the layout, where dihedral angles leave pins too little room."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np

from ..base.errors import tile_list
from ..base.findings import Finding, require_no_error
from ..base.native import native
from .cut_request import mesh_edges
from .stage import Inputs, Job, Picture, Result, Row, Stage, moved_vertices

# Cuts are chosen on the smoothed target; they leave tiles more room than contacts do.
_NO_CUTS = np.zeros((0, 2), np.int32)


@dataclass(frozen=True)
class TargetSmoothing(Result):
    """V: N x 3, vertices of the target from now on. The others are set with mend=on."""

    read_later = ("V",)
    V: np.ndarray
    block: Optional[dict] = None          # of report.json
    warned: tuple[Finding, ...] = ()
    F: Optional[np.ndarray] = None        # M x 3, where mending changed anything
    distance: Optional[np.ndarray] = None  # N, mm, of the vertices from the given surface

    def report(self) -> dict[str, Any]:
        return {} if self.block is None else {"mending": self.block}

    def rows(self, seconds: float) -> Sequence[Row]:
        return () if self.block is None else (Row("target smoothing", seconds),)

    def pictures(self) -> Sequence[Picture]:
        if self.distance is None or self.F is None:
            return ()
        of_tiles = self.distance[self.F].max(axis=1)
        return (Picture("Mending", "How far the mended target is from what was given, from both sides.",
                        "pictures.distance_view", {"V": self.V, "F": self.F, "values": of_tiles}),)


def _smooth_target(inputs: Inputs, job: Job) -> TargetSmoothing:
    target, parameters = inputs["target"], inputs.parameters
    if parameters.get("mend") != "on":
        return TargetSmoothing(target.V)
    smoothed = native.smooth_target(target.V, target.F, _NO_CUTS, _NO_CUTS, parameters.get("mend_max"),
                                    parameters, job)
    move = np.asarray(smoothed.move, float)
    moved, largest = int((move > 0).sum()), float(move.max(initial=0.0))
    pairs, faces = mesh_edges(target.F)
    border = move[np.unique(pairs[faces == 1])]
    tiles = sorted({pin.tile for pin in smoothed.fixed})
    actions = list(target.actions)
    if moved:
        actions.append(f"{moved} vertices moved by up to {largest:.2g} mm, which gives {len(tiles)} tiles "
                       f"room ({tile_list(tiles)})")
    if border.any():
        actions.append(f"{int((border > 0).sum())} of these are of the border, which moved by up to "
                       f"{border.max():.2g} mm where tiles had no room otherwise")
    V = np.ascontiguousarray(smoothed.V) if moved else target.V
    distance = native.surface_deviation(V, target.F, target.V, target.F, job).hausdorff_mm if moved else 0.0
    block = {"actions": actions, "moved_vertices": moved,
             "border_max_mm": float(border.max(initial=0.0)),
             "mean_mm": float(move[move > 0].mean()) if moved else 0.0, "max_mm": largest,
             "hausdorff_mm": max(target.mended_by, distance), "tiles": tiles,
             "remaining": sorted({pin.tile for pin in smoothed.remaining})}
    tiles, most = block["remaining"], parameters.get("mend_max")
    warned = [Finding.about("mending.remaining", tiles, at=tuple(tiles), most=most)] if tiles else []
    warned += _far(V, target, most, job)
    shown = (target.F, native.distances(V, *target.given)) if actions else ()
    return TargetSmoothing(V, block, tuple(warned), *shown)


def _far(V: np.ndarray, target: Any, most: float, job: Job) -> list[Finding]:
    """Warning where the tiles' surface is farther from the mesh before remeshing than mending may move it."""
    surface = target.source_V, target.source_F
    hausdorff = native.surface_deviation(V, target.F, *surface, job).hausdorff_mm
    if hausdorff <= most:
        return []
    far = native.distances(V[target.F].mean(axis=1), *surface) > most
    return [Finding.about("mending.far", np.flatnonzero(far), distance=hausdorff, most=most)]


TARGET = Stage("target smoothing", ("target",), frozenset({"target", "tiles"}), _smooth_target,
               label="Mending", commands=("solve",), shown=True)


_SAME_THICKNESS = 0.05  # relative difference of a wall and the tiles in its place
# Share of sides without room for a pin above which no vertex is moved: room that one tile gains its
# neighbours lose, and thousands of sides take half a minute each time a size is tried.
MOST_SHORT = 0.25


@dataclass(frozen=True)
class PinSmoothing(Result):
    """V: N x 3, vertices of the tiles from now on."""

    read_later = ("V",)
    V: np.ndarray
    warned: tuple[Finding, ...]
    requested: bool = False
    moved: Optional[dict] = None        # block of report.json, where vertices moved

    def report(self) -> dict[str, Any]:
        return {} if self.moved is None else {"pin_smoothing": self.moved}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("pin smoothing", seconds),) if self.requested else ()


def smooth_for_pins(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any,
                    job: Job) -> tuple[np.ndarray, Optional[dict]]:
    """Smoothed vertices, and the block of report.json; None where none moved."""
    if not parameters.get("run_repair"):
        return V, None
    figures = native.target_figures(V, F, edges, parameters)
    if figures.shaped and (figures.pin_area < parameters.get("A_pin_floor")).mean() > MOST_SHORT:
        return V, None
    smoothed = native.smooth_for_pins(V, F, edges, parameters, job)
    if not smoothed.reached:
        return V, None
    return smoothed.V, {"largest_move_mm": smoothed.largest_move_mm,
                        "pin_sides": [{"tile": pin.tile, "side": pin.side, "area_before_mm2": pin.area}
                                      for pin in smoothed.reached],
                        "remaining": len(smoothed.remaining),
                        "moved_vertices": moved_vertices(V, smoothed.V, F)}


def _run(inputs: Inputs, job: Job) -> PinSmoothing:
    target, edges, parameters = inputs["target"], inputs["cuts"].edges, inputs.parameters
    V, moved = smooth_for_pins(inputs["target smoothing"].V, target.F, edges, parameters, job)
    warned = require_no_error(native.check_target(V, target.F, edges, parameters), inputs.where)
    wall, H_body = target.wall, parameters.get("H_body")
    if wall is not None and abs(wall - H_body) > _SAME_THICKNESS * wall:
        warned += (Finding.about("wall", wall=wall, H_body=H_body),)
    return PinSmoothing(V, warned, parameters.get("run_repair"), moved)


STAGE = Stage("pin smoothing", ("target", "target smoothing", "cuts"), frozenset({"tiles", "repair"}), _run,
              label="Feasibility smoothing", commands=("solve",), shown=True)
