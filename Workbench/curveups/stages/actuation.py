# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape of the built piece: the finished design relaxed without friction, and on its way from flat, released
under its membranes, then shaken, then pressed over its former and let go."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import numpy as np

from ..base.findings import Finding
from ..base.native import native, translated
from . import settle
from .stage import Inputs, Job, Picture, Result, Row, Stage

RELAXED, SHAKEN = "relaxed", "shaken"
STATES = (RELAXED, "by_itself", SHAKEN, "pressed")  # after the first, each goes on from the last
DRAG = "Drag to turn. Fronts are yellow, backs are blue."


@dataclass(frozen=True)
class Actuation(Result):
    """block: as report.json has it. design: native Design. deviations: of each state that there
    is the mean distance of the tiles' fronts from the target (S x M, mm). relaxed: tiles of that state, as a
    frame (M x 7). The others have an entry a frame: load (one of STATES), time (s), stored energy (N mm),
    mean stretch ratio of the membranes, and poses (K x M x 7) as whole numbers of `steps` (7)."""

    block: Mapping[str, Any]
    design: Any
    deviations: np.ndarray
    relaxed: np.ndarray
    loads: Sequence[str]
    time: np.ndarray
    energy: np.ndarray
    stretch: np.ndarray
    poses: np.ndarray
    steps: np.ndarray

    def frame(self, number: int) -> np.ndarray:
        """One of `frames`, without the others."""
        return self.poses[number] * self.steps

    @property
    def frames(self) -> np.ndarray:
        """K x M x 7: how each tile has moved from its place in the actuated design, x, y, z (mm) and a unit
        quaternion (w, x, y, z)."""
        return self.poses * self.steps

    @property
    def stopped(self) -> bool:
        return self.block["stopped"]

    @property
    def states(self) -> dict[str, Mapping[str, Any]]:
        """Blocks of the states that there are, by name."""
        return states(self.block)

    @property
    def is_known(self) -> bool:
        """True where the piece comes to rest in all states."""
        return len(self.states) == len(STATES) and all(one["converged"] for one in self.states.values())

    @property
    def built(self) -> str:
        """State of the built piece: shaken, or relaxed where the path was stopped before."""
        return SHAKEN if SHAKEN in self.states else RELAXED

    def tiles(self, state: str) -> np.ndarray:
        """Tiles of a state, as a frame."""
        return self.relaxed if state == RELAXED else self.frame(self.states[state]["last_frame"])

    def deviation(self, state: str) -> np.ndarray:
        """Mean distance of each tile's front from the target in a state (M, mm)."""
        return self.deviations[list(self.states).index(state)]

    @property
    def open_tiles(self) -> list[int]:
        """Tiles of the contacts that stay open in the built piece."""
        return sorted({tile for pair in self.states[self.built]["open_contacts"] for tile in pair})

    def report(self) -> dict[str, Any]:
        return {"actuation": self.block}

    def findings(self) -> list[Finding]:
        """Findings of each state."""
        return findings(self.block)

    def warnings(self) -> Sequence[Finding]:
        return [one for one in self.findings() if one.group in ("actuation_restless", "actuation_stopped")]

    def pictures(self) -> Sequence[Picture]:
        if not len(self.time):
            return ()
        said = "; ".join(map(str, self.findings()))
        return (Picture("From flat to shape", f"{said[0].upper()}{said[1:]}. {DRAG}", "moving",
                        {"piece": self}),)

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("actuate", seconds, sum(one["steps"] for one in self.states.values())),)


def states(block: Mapping[str, Any]) -> dict[str, Mapping[str, Any]]:
    """States of a block of report.json that there are, by name."""
    return {name: block[name] for name in STATES if block[name]}


def findings(block: Mapping[str, Any]) -> list[Finding]:
    """Findings of a report block."""
    said = [_of_state(name, state, block["contacts"]) for name, state in states(block).items()]
    return _expected(block) + said + ([Finding("actuation_stopped")] if block["stopped"] else [])


def _expected(block: Mapping[str, Any]) -> list[Finding]:
    """Shape that the built piece is expected to have; none where a state that says it is missing."""
    found, spread = states(block), block["spread"]["mean_mm"]
    if not spread or not found.get("pressed", {}).get("converged"):
        return []
    shaken, count = found[SHAKEN], len(found[SHAKEN]["open_contacts"])
    return [Finding.about("actuation_expected.open" if count else "actuation_expected.closed",
                          (tile for pair in shaken["open_contacts"] for tile in pair),
                          mean=shaken["mean_mm"], largest=shaken["max_mm"], low=spread[0], high=spread[1],
                          open=count, count=block["contacts"],
                          pressed=found["pressed"]["mean_mm"])]


def _of_state(name: str, state: Mapping[str, Any], contacts: int) -> Finding:
    if not state["converged"]:
        return Finding(f"actuation_restless.{name}")
    more = {key: state[key] for key in ("taps", "force_n") if key in state}
    return Finding.about(f"actuation_{name}", (tile for pair in state["open_contacts"] for tile in pair),
                         mean=state["mean_mm"], largest=state["max_mm"], open=len(state["open_contacts"]),
                         count=contacts, **more)


def moved(points: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Points of the actuated tiles (M x K x 3, mm) in a frame (M x 7)."""
    w, axis = rows[:, None, 3:4], rows[:, None, 4:]
    across = 2 * np.cross(axis, points)
    return points + w * across + np.cross(axis, across) + rows[:, None, :3]


def _run(inputs: Inputs, job: Job) -> Actuation:
    design = inputs["design"].design.with_parameters(inputs.parameters)
    with translated(inputs.where):
        piece = native.actuate_design(design, job)
    frames = np.stack(piece.frames) if piece.frames else np.empty((0, len(design.F), 7))
    steps = np.maximum(np.abs(frames).max((0, 1), initial=0), 1e-9) / np.iinfo(np.int32).max
    return Actuation(piece.block, design, piece.deviations, piece.relaxed, tuple(piece.loads), piece.time,
                     piece.energy, piece.stretch, np.round(frames / steps).astype("<i4"), steps)


STAGE = Stage("actuation", ("design",), settle.PARTS, _run, label="From flat to shape", asked_by=("actuate",))
