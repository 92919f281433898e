# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape of the built piece: the finished design relaxed without friction, and its path from flat: released
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
STATES = (RELAXED, "by_itself", SHAKEN, "pressed")  # the last three follow one another
DRAG = "Drag to turn. Fronts are yellow, backs are blue."


@dataclass(frozen=True)
class Actuation(Result):
    """block: of report.json. design: native Design. deviations: mean distance of the tiles' fronts from the
    target in each state reached (S x M, mm). relaxed: tiles of that state, as a frame (M x 7). An entry for
    each of K frames: loads (of STATES), time (s), stored energy (N mm), mean stretch ratio of the membranes,
    poses (K x M x 7, integers in units of `steps`, 7)."""

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
        """A frame, M x 7."""
        return self.poses[number] * self.steps

    @property
    def frames(self) -> np.ndarray:
        """Motion of each tile from its place in the actuated design, K x M x 7: x, y, z (mm) and a unit
        quaternion (w, x, y, z)."""
        return self.poses * self.steps

    @property
    def stopped(self) -> bool:
        return self.block["stopped"]

    @property
    def states(self) -> dict[str, Mapping[str, Any]]:
        """Blocks of the states reached, by name."""
        return states(self.block)

    @property
    def is_known(self) -> bool:
        """True where the piece comes to rest in all states."""
        return len(self.states) == len(STATES) and all(state["converged"] for state in self.states.values())

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
        return [finding for finding in self.findings()
                if finding.group in ("actuation_restless", "actuation_stopped")]

    def pictures(self) -> Sequence[Picture]:
        if not len(self.time):
            return ()
        text = "; ".join(map(str, self.findings()))
        return (Picture("From flat to shape", f"{text[0].upper()}{text[1:]}. {DRAG}", "actuation.moving_view",
                        {"piece": self}),)

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("actuate", seconds, sum(state["steps"] for state in self.states.values())),)


def states(block: Mapping[str, Any]) -> dict[str, Mapping[str, Any]]:
    """States reached in a block of report.json, by name."""
    return {name: block[name] for name in STATES if block[name]}


def findings(block: Mapping[str, Any]) -> list[Finding]:
    """Findings of a report block."""
    of_states = [_of_state(name, state, block["contacts"]) for name, state in states(block).items()]
    return _expected(block) + of_states + ([Finding("actuation_stopped")] if block["stopped"] else [])


def _expected(block: Mapping[str, Any]) -> list[Finding]:
    """Expected shape of the built piece; empty where the states that tell it are missing."""
    reached, spread = states(block), block["spread"]["mean_mm"]
    if not spread or not reached.get("pressed", {}).get("converged"):
        return []
    shaken, count = reached[SHAKEN], len(reached[SHAKEN]["open_contacts"])
    return [Finding.about("actuation_expected.open" if count else "actuation_expected.closed",
                          (tile for pair in shaken["open_contacts"] for tile in pair),
                          mean=shaken["mean_mm"], largest=shaken["max_mm"], low=spread[0], high=spread[1],
                          open=count, count=block["contacts"],
                          pressed=reached["pressed"]["mean_mm"])]


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
    path = piece.frames
    frames = np.array([frame.tiles for frame in path]).reshape(-1, len(design.F), 7)
    steps = np.maximum(np.abs(frames).max((0, 1), initial=0), 1e-9) / np.iinfo(np.int32).max
    time, energy, stretch = (np.array([getattr(frame, name) for frame in path])
                             for name in ("time", "energy", "stretch"))
    return Actuation(piece.block, design, np.array(piece.deviations), piece.relaxed,
                     tuple(frame.load for frame in path), time, energy, stretch,
                     np.round(frames / steps).astype("<i4"), steps)


STAGE = Stage("actuation", ("design",), settle.PARTS, _run, label="From flat to shape", commands=("actuate",))
