# SPDX-License-Identifier: LGPL-2.1-or-later
"""Margins of every tile and contact of a target, before any layout, and the tiles that they block.

Folds, back faces, pins and overlaps of bodies are closed forms of the mesh, as for designs: these obstacles
are certain. Pins that run into parts facing them, and membranes that cut into tiles or are slack, depend on
the layout: they are estimated from pins as near to corners as possible, and from the conformal map with
which layouts begin. The limits of these estimates are those at which designs began to fail.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Iterator, Optional, Sequence

import numpy as np

from ..base.findings import Finding, Value
from ..base.native import native
from ..base.sentences import MARGINS
from .smoothing import smooth_for_pins
from .stage import Inputs, Job, Result, Stage

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

    read_later = ("V", "F", "blocked")
    V: np.ndarray                 # after smoothing for pins
    F: np.ndarray
    blocked: tuple[Obstacle, ...]
    figures: tuple[TileFigure, ...]
    contacts: np.ndarray          # N x 2 tiles
    dihedral: np.ndarray          # N, degrees, convex positive
    dihedral_margin: np.ndarray   # N, degrees by which it could grow before a back face vanishes
    least_dihedral_margin: np.ndarray  # M, degrees, over the tile's contacts; NaN: it has none
    back_scale: np.ndarray        # M: back face's length over the front's
    pin_area_margin: np.ndarray   # M x 2, mm2: largest pin's area less A_pin_min; NaN: no back faces
    membrane_clearance: np.ndarray  # M x 2, mm: of pins' tops over corners; NaN: no back faces
    stretch: np.ndarray           # M, of the conformal map; NaN: there is none
    stretch_range: np.ndarray     # M x 2: below the first the tile has no gaps, above the other its
    #                               membranes are slack
    sharpest: Optional[Finding] = None  # of folds that leave no room for back faces or pins

    @property
    def feasible(self) -> bool:
        """True without obstacles; contact forces are not considered."""
        return not self.blocked


def examine(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any) -> Feasibility:
    """Margins of a remeshed target that is cut along `edges` (C x 2). Raises native errors where it is no
    mesh of tiles."""
    get, count = parameters.get, len(F)
    margins = native.target_figures(V, F, edges, parameters)
    contacts, dihedral_margin = np.asarray(margins.contacts), np.asarray(margins.dihedral_margin)
    overlapping = np.array(margins.overlapping, np.int32).reshape(-1, 2)
    meeting = overlapping[:0]  # pairs whose pins meet, without those whose bodies overlap
    pin_area, clearance = np.full((2, count, 2), np.nan)
    if margins.shaped:
        pin_area, clearance = np.asarray(margins.pin_area), np.asarray(margins.membrane_clearance)
        known = set(map(tuple, np.sort(overlapping, axis=1).tolist()))
        facing = [pair for pair in native.facing_pins(V, F, edges, parameters) if tuple(pair) not in known]
        meeting = np.array(facing, np.int32).reshape(-1, 2)
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
        *(_obstacle("stretch", tile, False, stretch=float(stretch[tile]), low=float(ranges[tile, 0]),
                    high=float(ranges[tile, 1])) for tile in np.flatnonzero(too_stretched(stretch, ranges)))]
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
        pin_area - get("A_pin_min"), clearance, stretch, ranges)


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


def too_stretched(stretch: np.ndarray, ranges: np.ndarray) -> np.ndarray:
    """True for each tile of a map stretched beyond its range (Feasibility.stretch_range); false for all where
    a layout evens that out, or where there is no map of some."""
    with np.errstate(invalid="ignore"):
        slack, narrow = stretch > TOO_SLACK * ranges[:, 1], stretch < TOO_NARROW * ranges[:, 0]
    # One scale for the whole map: where it must be too large for some, it is too small for others.
    uneven = slack.mean() > SHARE and narrow.mean() > SHARE and not np.isnan(stretch).any()
    return (slack | narrow) & uneven


def sharpest_fold(margins: Feasibility, parameters: Any) -> Optional[Finding]:
    """Finding on the sharpest of the folds that leave a tile without a back face or room for pins, and on a
    radius that would do; None where no fold is that sharp."""
    tiles = {obstacle.tile for obstacle in margins.blocked if obstacle.obstacle in ("fold", "pin")}
    if not tiles:
        return None
    sizes = {"L": parameters.get("L"), "H_body": parameters.get("H_body")}
    least = least_radius(parameters)
    if math.isinf(least):
        return Finding.about("sharp.flat", tiles, **sizes)
    corners, at = margins.V[margins.F], margins.contacts
    double = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    shared = (margins.F[at[:, 0], :, None] == margins.F[at[:, 1], None, :]).any(axis=2)
    ends = margins.V[margins.F[at[:, 0]][shared].reshape(-1, 2)]
    # Between centroids, across the edge: thirds of both heights.
    across = double[at].sum(axis=1) / (3 * np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1))
    bend = np.radians(np.abs(margins.dihedral)) / across
    bend[~np.isin(at, list(tiles)).any(axis=1)] = 0
    if bend.max(initial=0) * least <= 1:  # the tiles themselves are too narrow
        return None
    contact = int(np.argmax(bend))
    tile = next(int(tile) for tile in at[contact] if int(tile) in tiles)
    return Finding.about("sharp", [tile], tile=(tile,), radius=1 / float(bend[contact]), least=least, **sizes)


def least_radius(parameters: Any) -> float:
    """Least radius (mm) of a cylinder on which equilateral tiles have back faces and room for pins, whether
    their edges run along it or around it; infinite where they have none on a plane."""
    L, wanted = parameters.get("L"), parameters.get("A_pin_floor")
    rows = np.arange(7)
    a, b = np.meshgrid(rows, rows, indexing="ij")
    plane = L * np.stack([a + b / 2, math.sqrt(3) / 2 * b], axis=-1).reshape(-1, 2)
    first = (7 * a + b)[:-1, :-1].ravel()
    F = np.concatenate([np.stack([first, first + 7, first + 1], axis=1),
                        np.stack([first + 7, first + 8, first + 1], axis=1)]).astype(np.int32)
    inner = ~np.isin(F, np.flatnonzero((np.minimum(a, b) == 0) | (np.maximum(a, b) == 6))).any(axis=1)

    def has_room(radius: float) -> bool:
        for (around, along), tiles in ((plane.T, F), (plane.T[::-1], F[:, ::-1])):
            angle = (around - around.mean()) / radius
            V = np.stack([radius * np.sin(angle), along, radius * np.cos(angle)], axis=1)
            figures = native.target_figures(V, tiles, np.empty((0, 2), np.int32), parameters)
            if not figures.shaped or (np.asarray(figures.back_scale)[inner] < LEAST_BACK_FACE).any() or (
                    np.asarray(figures.pin_area)[inner] < wanted).any():
                return False
        return True

    sharp, wide = L / 1.5, 1000 * L  # an edge turns by less than a right angle
    if not has_room(wide):
        return math.inf
    while wide > 1.02 * sharp:
        middle = math.sqrt(sharp * wide)
        sharp, wide = (sharp, middle) if has_room(middle) else (middle, wide)
    return wide


def _run(inputs: Inputs, job: Job) -> Feasibility:
    V, edges, F = inputs["target smoothing"].V, inputs["division"].edges, inputs["target"].F
    job("checking tiles")
    margins = examine(V, F, edges, inputs.parameters)
    if not any(obstacle.obstacle == "fold" for obstacle in margins.blocked):
        moved_V, moved = smooth_for_pins(V, F, edges, inputs.parameters, job)
        if moved:
            margins = examine(moved_V, F, edges, inputs.parameters)
    return replace(margins, sharpest=sharpest_fold(margins, inputs.parameters))


STAGE = Stage("feasibility", ("target", "target smoothing", "division"),
              frozenset({"target", "tiles", "layout", "repair"}), _run,
              label="Feasibility", commands=("check",), shown=True)
