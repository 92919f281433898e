# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds which parts of a target can become tiles, before any layout: margins of every tile and contact.

Folds, back faces, pins and overlaps of bodies are closed forms of the mesh, the same that a design is
refused by: what they block is certain. Where pins run into parts that face them, and where membranes cut
into tiles or are slack, depends on the layout: that is estimated from pins that stand as near to corners
as they may, and from the conformal map with which layouts begin. The limits of these estimates are those
at which designs began to fail.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Iterator, Optional, Sequence

import numpy as np

from ..base.findings import Finding, Value
from ..base.native import native
from ..base.sentences import MARGINS
from .smoothing import smooth_for_pins
from .stage import Inputs, Job, Result, Stage, digest

_SIDES = ("front", "back")
LEAST_BACK_FACE = 1e-3  # of the front face's length
# Estimates. A membrane sags: it passes this part of H_pin below the tops of the pins around a corner.
SAG = 0.3
# Layouts differ from their conformal map: they even out tiles so far beyond the range of stretch, and bear
# the rest where it is a small share of all tiles.
TOO_SLACK, TOO_NARROW, SHARE = 1.2, 0.7, 0.05


@dataclass(frozen=True)
class Obstacle(Value):
    """Why a tile can't be made; not `certain`: by an estimate."""

    why: Finding
    certain: bool = True

    @property
    def tile(self) -> int:
        return self.why.tiles[0]

    @property
    def obstacle(self) -> str:
        """"fold", "pin", "overlap", "closed", "membrane", "stretch"."""
        return self.why.group


@dataclass(frozen=True)
class TileFigure(Value):
    """A figure of every tile (NaN where there is none) beside the value that it needs: at least that, or at
    most (`most`). obstacle, side: of tiles that miss it, where the figure has a side; estimate: such an
    obstacle is not certain."""

    name: str
    values: np.ndarray  # M
    needed: float
    obstacle: str
    side: str = ""
    estimate: bool = False
    most: bool = False

    def worst(self) -> Optional[int]:
        """The tile with the worst value; None where there is no value."""
        if np.isnan(self.values).all():
            return None
        return int(np.nanargmax(self.values) if self.most else np.nanargmin(self.values))

    def short(self, blocked: Sequence[Obstacle]) -> int:
        """How many tiles miss it."""
        return len({one.tile for one in blocked if one.obstacle == self.obstacle
                    and self.side in ("", one.why.figures.get("side"))})


@dataclass(frozen=True)
class Feasibility(Result):
    """M tiles, N contacts. `blocked`: in the order of tiles, of which one may be there several times."""

    V: np.ndarray                 # as pins have made room for themselves
    F: np.ndarray
    blocked: tuple[Obstacle, ...]
    figures: tuple[TileFigure, ...]
    contacts: np.ndarray          # N x 2 tiles
    dihedral: np.ndarray          # N, degrees, convex positive
    dihedral_margin: np.ndarray   # N, degrees by which it could grow before a back face vanishes
    least_dihedral_margin: np.ndarray  # M, degrees, of the tile's contacts; NaN: it has none
    back_scale: np.ndarray        # M: back face's length over the front's
    interface_share: np.ndarray   # N: interface's back edge over its front edge; NaN: no back faces
    pin_area_margin: np.ndarray   # M x 2, mm2: largest pin's area less A_pin_min; NaN: no back faces
    membrane_clearance: np.ndarray  # M x 2, mm: of pins' tops over corners; NaN: no back faces
    stretch: np.ndarray           # M, of the conformal map; NaN: there is none
    stretch_range: np.ndarray     # M x 2: below the first the tile has no gaps, above the other its
    #                               membranes are slack
    trimmed: np.ndarray           # pairs of tiles without a common vertex that are cut off
    overlapping: np.ndarray       # pairs that no plane parts
    meeting: np.ndarray           # other pairs without a common vertex of which pins run into one another
    reached: int = 0              # pin sides for which vertices were moved

    @property
    def feasible(self) -> bool:
        """Whether nothing is known or expected to be in the way; contact forces are not looked at."""
        return not self.blocked

    @property
    def content(self) -> str:
        return digest(self.V, self.F, self.blocked)


def examine(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any) -> Feasibility:
    """The margins of a remeshed target that is cut along `edges` (C x 2). Raises native errors where it is no
    mesh of tiles at all."""
    get, count = parameters.get, len(F)
    margins = native.target_figures(V, F, edges, parameters)
    contacts, dihedral_margin = np.asarray(margins.contacts), np.asarray(margins.dihedral_margin)
    overlapping = np.array(margins.overlapping, np.int32).reshape(-1, 2)
    if margins.shaped:
        pin_area, share = np.asarray(margins.pin_area), np.asarray(margins.interface_share)
        clearance = np.asarray(margins.membrane_clearance)
        meeting = _meeting(V, F, edges, parameters, overlapping)
    else:
        pin_area, share = np.full((count, 2), np.nan), np.full(len(contacts), np.nan)
        clearance, meeting = np.full((count, 2), np.nan), overlapping
    least_dihedral_margin = np.full(count, np.inf)
    for side in range(2):
        np.minimum.at(least_dihedral_margin, contacts[:, side], dihedral_margin)
    least_dihedral_margin[np.isinf(least_dihedral_margin)] = np.nan
    stretch = np.asarray(margins.stretch)
    ranges = np.stack([margins.least_stretch, margins.most_stretch], axis=1)
    blocked = [
        *(_obstacle("fold", tile) for tile in np.flatnonzero(margins.back_scale < LEAST_BACK_FACE)),
        *_too_small("pin", "area", pin_area, get("A_pin_floor"), True),
        *_in_pairs("overlap.bodies", overlapping, True), *_in_pairs("overlap.pins", meeting, False),
        *(_obstacle("closed.tile", tile) for tile in np.flatnonzero(np.isnan(stretch))),
        *_too_small("membrane.room", "room", clearance, SAG * get("H_pin"), False),
        *_badly_stretched(stretch, ranges)]
    with np.errstate(divide="ignore", invalid="ignore"):  # where not even the smallest pins hold a membrane
        of_least, of_most = (stretch[:, None] / ranges).T
    pairs = np.concatenate([overlapping, meeting]).ravel()
    figures = (
        (least_dihedral_margin, 0.0, "fold"), (margins.back_scale, LEAST_BACK_FACE, "fold"),
        (pin_area[:, 0], get("A_pin_floor"), "pin", "front"),
        (pin_area[:, 1], get("A_pin_floor"), "pin", "back"),
        (clearance[:, 0], SAG * get("H_pin"), "membrane", "front", True),
        (clearance[:, 1], SAG * get("H_pin"), "membrane", "back", True),
        (of_least, TOO_NARROW, "stretch", "", True), (of_most, TOO_SLACK, "stretch", "", True, True),
        (np.bincount(pairs, minlength=count).astype(float), 0.0, "overlap", "", False, True))
    return Feasibility(
        V, F, tuple(sorted(blocked, key=lambda one: one.tile)),
        tuple(TileFigure(name, *figure) for name, figure in zip(MARGINS, figures)), contacts,
        np.asarray(margins.dihedral), dihedral_margin, least_dihedral_margin, np.asarray(margins.back_scale),
        share, pin_area - get("A_pin_min"), clearance, stretch, ranges,
        np.array(margins.trimmed, np.int32).reshape(-1, 2), overlapping, meeting)


def _obstacle(kind: str, tile: int, certain: bool = True, **figures: Any) -> Obstacle:
    return Obstacle(Finding.about(kind, [tile], **figures), certain)


def _too_small(kind: str, figure: str, values: np.ndarray, least: float, certain: bool) -> Iterator[Obstacle]:
    """Sides of tiles (values: M x 2) that have less; figure: what sentences call the value."""
    with np.errstate(invalid="ignore"):
        small = np.argwhere((values < least) | (values <= 0))
    for tile, side in small:
        yield _obstacle(kind, tile, certain, side=_SIDES[side], least=least,
                        **{figure: float(values[tile, side])})


def _in_pairs(kind: str, pairs: np.ndarray, certain: bool) -> Iterator[Obstacle]:
    """Of either tile the other."""
    for a, b in (*pairs, *pairs[:, ::-1]):
        yield _obstacle(kind, a, certain, other=(int(b),))


def _meeting(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, others: np.ndarray
             ) -> np.ndarray:
    """Pairs whose pins meet, but for those whose bodies do."""
    known = {tuple(sorted(pair)) for pair in others.tolist()}
    pairs = [pair for pair in native.facing_pins(V, F, edges, parameters) if tuple(pair) not in known]
    return np.array(pairs, np.int32).reshape(-1, 2)


def _badly_stretched(stretch: np.ndarray, ranges: np.ndarray) -> Iterator[Obstacle]:
    if np.isnan(stretch).any():  # what has to be cut open first
        return
    for tile in np.flatnonzero(too_stretched(stretch, ranges)):
        low, high = ranges[tile]
        yield _obstacle("stretch", tile, certain=False, stretch=float(stretch[tile]), low=float(low),
                        high=float(high))


def too_stretched(stretch: np.ndarray, ranges: np.ndarray) -> np.ndarray:
    """Of each tile of a map whether it is beyond the range of stretch that it can do with, as Feasibility has
    them; none where a layout evens that out."""
    with np.errstate(invalid="ignore"):
        slack, narrow = stretch > TOO_SLACK * ranges[:, 1], stretch < TOO_NARROW * ranges[:, 0]
    # One scale for the whole map: where it must be too large for some, it is too small for others.
    return (slack | narrow) & (slack.mean() > SHARE) & (narrow.mean() > SHARE)


def _run(inputs: Inputs, job: Job) -> Feasibility:
    V, edges, F = inputs["target smoothing"].V, inputs["division"].edges, inputs["target"].F
    job("checking tiles")
    found = examine(V, F, edges, inputs.parameters)
    if not any(one.obstacle == "fold" for one in found.blocked):
        moved_V, moved = smooth_for_pins(V, F, edges, inputs.parameters, job)
        if moved:
            return replace(examine(moved_V, F, edges, inputs.parameters), reached=len(moved["pin_sides"]))
    return found


STAGE = Stage("feasibility", ("target", "target smoothing", "division"),
              frozenset({"target", "tiles", "layout", "repair"}), _run,
              label="Feasibility", asked_by=("check",), shown=True)
