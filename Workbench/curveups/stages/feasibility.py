# SPDX-License-Identifier: LGPL-2.1-or-later
"""Margins of every tile and contact of a target, before any layout, and the tiles that they block.

Folds, back faces, pins and overlaps of bodies are closed forms of the mesh, as for designs: these obstacles
are certain. Pins that run into parts facing them, and membranes that cut into tiles or are slack, depend on
the layout: they are estimated from pins as near to corners as possible, and from the conformal map with
which layouts begin. The limits of these estimates are those at which designs began to fail.
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
# Estimates. A membrane sags below the tops of the pins around a corner by this part of H_pin.
SAG = 0.3
# Layouts even out stretch of the conformal map up to these factors beyond the range, and beyond them for this
# share of all tiles.
TOO_SLACK, TOO_NARROW, SHARE = 1.2, 0.7, 0.05


@dataclass(frozen=True)
class Obstacle(Value):
    """Reason why a tile can't be made; certain: not an estimate."""

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
    """A figure of every tile (NaN: none) and its bound: least value, or largest (`most`). obstacle, side: of
    the tiles beyond the bound; side may be empty. estimate: such an obstacle is not certain."""

    name: str
    values: np.ndarray  # M
    needed: float
    obstacle: str
    side: str = ""
    estimate: bool = False
    most: bool = False

    def worst(self) -> Optional[int]:
        """Tile with the worst value; None without values."""
        if np.isnan(self.values).all():
            return None
        return int(np.nanargmax(self.values) if self.most else np.nanargmin(self.values))

    def short(self, blocked: Sequence[Obstacle]) -> int:
        """Number of tiles beyond the bound."""
        return len({obstacle.tile for obstacle in blocked if obstacle.obstacle == self.obstacle
                    and self.side in ("", obstacle.why.figures.get("side"))})


@dataclass(frozen=True)
class Feasibility(Result):
    """M tiles, N contacts. blocked: in the order of tiles; a tile may have several obstacles."""

    V: np.ndarray                 # after smoothing for pins
    F: np.ndarray
    blocked: tuple[Obstacle, ...]
    figures: tuple[TileFigure, ...]
    contacts: np.ndarray          # N x 2 tiles
    dihedral: np.ndarray          # N, degrees, convex positive
    dihedral_margin: np.ndarray   # N, degrees by which it could grow before a back face vanishes
    least_dihedral_margin: np.ndarray  # M, degrees, over the tile's contacts; NaN: it has none
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
        """True without obstacles; contact forces are not considered."""
        return not self.blocked

    @property
    def content(self) -> str:
        return digest(self.V, self.F, self.blocked)


def examine(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any) -> Feasibility:
    """Margins of a remeshed target that is cut along `edges` (C x 2). Raises native errors where it is no
    mesh of tiles."""
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
        V, F, tuple(sorted(blocked, key=lambda obstacle: obstacle.tile)),
        tuple(TileFigure(name, *figure) for name, figure in zip(MARGINS, figures)), contacts,
        np.asarray(margins.dihedral), dihedral_margin, least_dihedral_margin, np.asarray(margins.back_scale),
        share, pin_area - get("A_pin_min"), clearance, stretch, ranges,
        np.array(margins.trimmed, np.int32).reshape(-1, 2), overlapping, meeting)


def _obstacle(kind: str, tile: int, certain: bool = True, **figures: Any) -> Obstacle:
    return Obstacle(Finding.about(kind, [tile], **figures), certain)


def _too_small(kind: str, figure: str, values: np.ndarray, least: float, certain: bool) -> Iterator[Obstacle]:
    """Obstacles of sides (values: M x 2) below `least`. figure: name of the value in sentences."""
    with np.errstate(invalid="ignore"):
        small = np.argwhere((values < least) | (values <= 0))
    for tile, side in small:
        yield _obstacle(kind, tile, certain, side=_SIDES[side], least=least,
                        **{figure: float(values[tile, side])})


def _in_pairs(kind: str, pairs: np.ndarray, certain: bool) -> Iterator[Obstacle]:
    """Obstacles of both tiles of each pair."""
    for a, b in (*pairs, *pairs[:, ::-1]):
        yield _obstacle(kind, a, certain, other=(int(b),))


def _meeting(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, others: np.ndarray
             ) -> np.ndarray:
    """Pairs whose pins meet, without the pairs whose bodies overlap (`others`)."""
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
    """True for each tile of a map stretched beyond its range (Feasibility.stretch_range); false for all where
    a layout evens that out."""
    with np.errstate(invalid="ignore"):
        slack, narrow = stretch > TOO_SLACK * ranges[:, 1], stretch < TOO_NARROW * ranges[:, 0]
    # One scale for the whole map: where it must be too large for some, it is too small for others.
    return (slack | narrow) & (slack.mean() > SHARE) & (narrow.mean() > SHARE)


def _run(inputs: Inputs, job: Job) -> Feasibility:
    V, edges, F = inputs["target smoothing"].V, inputs["division"].edges, inputs["target"].F
    job("checking tiles")
    margins = examine(V, F, edges, inputs.parameters)
    if not any(obstacle.obstacle == "fold" for obstacle in margins.blocked):
        moved_V, moved = smooth_for_pins(V, F, edges, inputs.parameters, job)
        if moved:
            return replace(examine(moved_V, F, edges, inputs.parameters), reached=len(moved["pin_sides"]))
    return margins


STAGE = Stage("feasibility", ("target", "target smoothing", "division"),
              frozenset({"target", "tiles", "layout", "repair"}), _run,
              label="Feasibility", asked_by=("check",), shown=True)
