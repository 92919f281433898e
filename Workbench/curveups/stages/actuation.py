# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets the finished design rise from flat under its membranes, with friction: whether it arrives by itself,
what holds it back, and the path."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.findings import Finding
from ..base.native import native, translated
from ..base.parameters import parameter, with_values
from ..base.releases import CUT
from . import settle
from .stage import Inputs, Job, Picture, Result, Row, Stage, digest


HANDS = "Before hands press, from two sides. They press the tiles in red to their places, as the arrows show."
MOST_PAIRS = 8    # that are named; the hardest
MOST_TOUCHES = 6  # that are named; more are a matter of a former


@dataclass(frozen=True)
class ActuationStart(Result):
    """Where tiles begin, as the command line has it (flat, target, a file of frames), and for all but flat a
    row a tile, as frames have them. hands: whether to find out what brings a piece home that jams; the path
    is the same. memory: of a path that ended or came by there, of the design that `of` is a digest of: it
    goes on as it would have. release: one of RELEASES; all but CUT begin flat. press: with hands, the tiles
    that they press, instead of looking for some, of a design whose tiles `of` is a digest of; of other tiles
    it is as if there were none. force: N on each, or as native code has it."""

    begin: str = "flat"
    poses: Optional[np.ndarray] = None
    hands: bool = False
    memory: Optional[np.ndarray] = None
    of: str = ""
    release: str = CUT
    press: tuple[int, ...] = ()
    force: Optional[float] = None

    @property
    def content(self) -> str:
        remembered = [self.memory, self.of] if self.memory is not None else []
        return digest(self.begin, self.poses, *(["hands"] if self.hands else []), *remembered,
                      *([self.release] if self.release != CUT else []),
                      *(["press", self.press, self.force, self.of] if self.press else []))


@dataclass(frozen=True)
class Actuation(Result):
    """block: as report.json has it. design: native Design. Of the frames: s, N mm, N mm, the mean stretch
    ratio of the membranes, and poses (K x M x 7) as whole numbers of `steps` (7); the last `by_hand` of them
    are of hands, from where the path ends. hand_work: N mm that hands have put in, of all frames. memories:
    of the path's frames, as native code has them; documents do without."""

    block: Mapping[str, Any]
    design: Any
    time: np.ndarray
    energy: np.ndarray
    friction: np.ndarray
    stretch: np.ndarray
    poses: np.ndarray
    steps: np.ndarray
    by_hand: int = 0
    hand_work: np.ndarray = field(default_factory=lambda: np.zeros(0))
    memories: Sequence[np.ndarray] = field(default=(), metadata={"transient": True})

    @property
    def path_count(self) -> int:
        """How many frames are of the path."""
        return len(self.time) - self.by_hand

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
    def phase_names(self) -> list[str]:
        """Of each frame of the path, what hands did last; nothing where they cut the piece out at once."""
        phases = self.block.get("phases", [])
        ends = [phase["first_frame"] for phase in phases[1:]] + [self.path_count]
        return [phase["phase"] for phase, end in zip(phases, ends) for _ in range(end - phase["first_frame"])]

    @property
    def doing(self) -> list[str]:
        """Of each frame, what hands do or did last; nothing of a path that begins cut out."""
        shaken = self.block["by_hand"]["shaken_frame"] + 1 if self.by_hand else 0
        return [*(self.phase_names or [""] * self.path_count), *["shaking"] * shaken,
                *["pressing"] * (self.by_hand - shaken)]

    @property
    def ends(self) -> dict[int, Mapping[str, Any]]:
        """Where the piece comes to rest, by the frame: after the path, shaken, and pressed by hand."""
        found = {self.path_count - 1: self.block}
        if self.by_hand:
            hands = self.block["by_hand"]
            if hands["shaken_frame"] >= 0:
                found[self.path_count + hands["shaken_frame"]] = hands["shaken"]
            if self.pressed_tiles:
                found[len(self.time) - 1] = hands["end"]
        return {frame: end for frame, end in found.items() if end["converged"]}

    @property
    def wedged_tiles(self) -> list[int]:
        """The tiles that the answer names where the piece would not arrive without friction."""
        if not self.block["trap"]:
            return []
        return sorted(set(_tiles(self.block["sampled"][0]["wedged"][:MOST_PAIRS])))

    @property
    def open_tiles(self) -> list[int]:
        """The tiles of open contacts."""
        return sorted(set(_tiles(self.block["open_contacts"])))

    @property
    def pressed_tiles(self) -> list[int]:
        """The tiles that hands press."""
        return sorted(tile for touch in self.block.get("hands", ()) for tile in touch["tiles"])

    def report(self) -> dict[str, Any]:
        return {"actuation": self.block}

    def findings(self) -> list[Finding]:
        """The answer, then what keeps the piece from its shape."""
        return findings(self.block)

    def warnings(self) -> Sequence[Finding]:
        return [one for one in self.findings() if one.kind != "actuation_arrives"]

    def pictures(self) -> Sequence[Picture]:
        said = "; ".join(map(str, self.findings()))
        hands = (Picture("By hand", HANDS, "hands", {"found": self}),) if self.pressed_tiles else ()
        return (Picture("From flat to shape", f"{said[0].upper()}{said[1:]}. Drag to turn. Fronts are "
                        "yellow, backs are blue.", "moving", {"found": self}), *hands)

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("actuate", seconds, self.block["steps"]),)


def path_digest(design: Any) -> str:
    """Of what a frame's memory depends on: that of other designs is of no use. With another friction, or
    another tolerance, a path goes on from where it was."""
    own = with_values(design.parameters, {name: parameter(name).default
                                          for name in ("friction_coefficient", "hold_tolerance")})
    return digest(native.MEMORY_FORMAT, native.write_design(design.with_parameters(own)))


def tiles_digest(design: Any) -> str:
    """Of what numbers of tiles stand for."""
    return digest(np.asarray(design.F))


def moved(points: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Points of the actuated tiles (M x K x 3, mm) in a frame (M x 7)."""
    w, axis = rows[:, None, 3:4], rows[:, None, 4:]
    across = 2 * np.cross(axis, points)
    return points + w * across + np.cross(axis, across) + rows[:, None, :3]


def findings(block: Mapping[str, Any]) -> list[Finding]:
    """What a block says."""
    found = _of_path(block)
    if block.get("contacts_anew"):
        found.append(Finding.about("actuation_anew"))
    return found if block["arrives"] is None else found + _of_hands(block)


def _of_path(block: Mapping[str, Any]) -> list[Finding]:
    if block["arrives"] is None:
        return [Finding.about("actuation_stopped" if block["stopped"] else "actuation_restless")]
    open_pairs = _pairs(block["open_contacts"])
    if block["arrives"]:
        found = [Finding.about("actuation_arrives", shortfall=block["shortfall_mm"])]
    elif open_pairs:
        found = [Finding.about("actuation_jammed", _tiles(open_pairs), shortfall=block["shortfall_mm"],
                               open=len(open_pairs), count=block["contacts"], contacts=open_pairs)]
    else:
        found = [Finding.about("actuation_short", shortfall=block["shortfall_mm"],
                               most=block["tolerance_mm"])]
    if block["trap"]:
        wedged = _pairs(block["sampled"][0]["wedged"])
        found.append(Finding.about("actuation_trapped" if wedged else "actuation_elsewhere", _tiles(wedged),
                                   distance=block["trap_distance_mm"], pairs=wedged))
    elif not block["arrives"] and block["reach_friction"] is not None:
        found.append(Finding.about("actuation_friction", reach=block["reach_friction"]))
    return found


def _of_hands(block: Mapping[str, Any]) -> list[Finding]:
    """What to do by hand, where that was asked."""
    if "by_hand" not in block:
        return [Finding.about("hands_stopped")] if block["stopped"] else []
    hands, touches = block["by_hand"], block["hands"]
    # Where nothing more does, it is what shaking leaves.
    end = hands["end"] if block["hands"] or hands["reached"] == "none" else hands["shaken"]
    tiles = [tile for touch in touches for tile in touch["tiles"]]
    figures = {"taps": hands["taps"], "shortfall": end["shortfall_mm"], "open": len(end["open_contacts"]),
               "count": block["contacts"]}
    if not tiles:
        if hands["reached"] != "none" and not hands["tried"]:
            return [Finding.about("hands_shaken", **figures)]
        kind = "hands_none" if hands["reached"] == "none" else "hands_no_more"
        return [Finding.about(kind, tried=hands["tried"], force=hands["largest_force_n"], **figures)]
    figures["force"] = touches[0]["force_n"]
    if hands["reached"] == "none":  # tiles that were chosen
        if not end["converged"]:
            return [Finding.about("hands_restless", tiles)]
        return [Finding.about("hands_short", tiles, pressed=len(tiles), **figures)]
    if len(touches) > MOST_TOUCHES:
        return [Finding.about("hands_over", tiles, pressed=len(tiles), **figures)]
    each = tuple(Finding.about(f"hands_touch.{touch['way']}", touch["tiles"], which=tuple(touch["tiles"]))
                 for touch in touches)
    return [Finding.about("hands_press", tiles, touches=each, **figures)]


def _pairs(pairs: Sequence[Sequence[int]]) -> tuple[tuple[int, ...], ...]:
    return tuple(tuple(pair) for pair in pairs)


def _tiles(pairs: Sequence[Sequence[int]]) -> list[int]:
    return [tile for pair in pairs for tile in pair]


def _run(inputs: Inputs, job: Job) -> Actuation:
    start = inputs[START.name]
    design = inputs["design"].design.with_parameters(inputs.parameters)
    with translated(inputs.where if start.poses is None else start.begin):
        memory = start.memory if start.of == path_digest(design) else None
        pressed = {"press": start.press, "force": start.force} if start.of == tiles_digest(design) else {}
        found = native.actuate_design(design, job, start.poses, memory, hands=start.hands,
                                      release=start.release, **pressed)
    frames = np.stack([*found.frames, *found.hand_frames])
    steps = np.maximum(np.abs(frames).max((0, 1)), 1e-9) / np.iinfo(np.int32).max
    from_file = start.poses is not None and start.begin != "target"
    block = found.block | ({"contacts_anew": True} if from_file and memory is None else {})
    return Actuation(block, design, found.time, found.energy, found.friction, found.stretch,
                     np.round(frames / steps).astype("<i4"), steps, len(found.hand_frames), found.hand_work,
                     found.memories)


START = Stage("actuation start", (), frozenset(), lambda inputs, job: ActuationStart())
STAGE = Stage("actuation", ("design", START.name), settle.PARTS, _run, label="From flat to shape",
              asked_by=("actuate",))
