# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feasibility smoothing: moves vertices a little before the layout where dihedral angles leave pins too
little space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Optional, Sequence

import numpy as np

from ..base.findings import Finding, settle
from ..base.native import native
from .stage import Inputs, Job, Result, Row, Stage, digest, moved_vertices

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
    if not _asked(parameters) or mostly_short(V, F, edges, parameters):
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


def _asked(parameters: Any) -> bool:
    return bool(parameters.get("run_repair"))


def _run(inputs: Inputs, job: Job) -> PinSmoothing:
    target, edges, parameters = inputs["target"], inputs["cuts"].edges, inputs.parameters
    V, moved = smooth_for_pins(inputs["target smoothing"].V, target.F, edges, parameters, job)
    found = settle(native.check_target(V, target.F, edges, parameters), inputs.where)
    return PinSmoothing(V, (*found, *_other_thickness(target.wall, parameters)), _asked(parameters), moved)


def _other_thickness(wall: Optional[float], parameters: Any) -> Iterator[Finding]:
    H_body = parameters.get("H_body")
    if wall is not None and abs(wall - H_body) > _SAME_THICKNESS * wall:
        yield Finding.about("wall", wall=wall, H_body=H_body)


STAGE = Stage("pin smoothing", ("target", "target smoothing", "cuts"), frozenset({"tiles", "repair"}), _run,
              label="Feasibility smoothing", asked_by=("solve",), shown=True)
