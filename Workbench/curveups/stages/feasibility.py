# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds which parts of a target can become tiles, before any layout: margins of every tile and contact.

Folds, back faces, pins and overlaps of bodies are closed forms of the mesh, the same that a design is
refused by: what they block is certain. Where pins run into parts that face them, and where membranes cut
into tiles or are slack, depends on the layout: that is estimated from pins that stand as near to corners
as they may, and from the conformal map with which layouts begin. The limits of these estimates are those
at which designs began to fail. Near them a trial decides (trial_layout.py).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Optional

import numpy as np

from ..base.findings import Finding
from ..base.native import native
from ..base.value import Value
from .pin_smoothing import mostly_short, smooth_for_pins
from .target_smoothing import smooth_target
from .stage import Inputs, Job, Result, Stage, digest

_SIDES = ("front", "back")
# Estimates. A membrane sags: it passes this part of H_pin below the tops of the pins around a corner.
SAG = 0.3
# Layouts differ from their conformal map: they even out tiles so far beyond the range of stretch, and bear
# the rest where it is a small share of all tiles.
TOO_SLACK, TOO_NARROW, SHARE = 1.2, 0.7, 0.05
# No size is tried with moved vertices where more sides than this share miss A_pin_min (tiles are too small
# then, not folds too sharp), or a membrane lacks more than this part of L. With 106 sizes of 17 targets no
# such size became feasible; the lowest membrane gained 0.008 L at most.
MOST_SMALL, MOST_CLEARED = 1 / 3, 1 / 40


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

    def is_at(self, obstacle: str, side: str) -> bool:
        """Whether it is this one, on this side."""
        return self.obstacle == obstacle and self.why.figures.get("side") == side


@dataclass(frozen=True)
class Feasibility(Result):
    """M tiles, N contacts. `blocked`: in the order of tiles, of which one may be there several times."""

    V: np.ndarray                 # as pins have made room for themselves
    F: np.ndarray
    L: float                      # mean edge length, mm
    blocked: tuple[Obstacle, ...]
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
    reached: int                  # pin sides for which vertices were moved

    @property
    def feasible(self) -> bool:
        """Whether nothing is known or expected to be in the way; contact forces are not looked at."""
        return not self.blocked

    @property
    def possible(self) -> bool:
        """Whether nothing is known to be in the way, estimates aside."""
        return not any(one.certain for one in self.blocked)

    @property
    def content(self) -> str:
        return digest(self.V, self.F, self.blocked)


def examine(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job) -> Feasibility:
    """The margins of a remeshed target that is cut along `edges` (C x 2), after pins have made room for
    themselves as before a layout. Raises native errors where it is no mesh of tiles at all."""
    reached = 0
    if native.tile_margins(V, F, edges, parameters).shaped:
        V, moved = smooth_for_pins(V, F, edges, parameters, job)
        reached = len(moved["pin_sides"]) if moved else 0
    return _margins(V, F, edges, parameters, reached)


def sizes_do(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job,
             sag: float = SAG) -> bool:
    """Whether `examine` finds nothing in the way that depends on sizes, after smoothing where mending is on:
    closed surfaces stay closed. Room for pins is only made where folds and other parts leave any. `sag`: the
    part of H_pin by which membranes are to clear tiles."""
    if _sizes_do(V, F, edges, parameters, job, sag):
        return True
    return parameters.get("mend") == "on" and _mends(V, F, edges, parameters, job, sag) is not None


def _mends(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job, sag: float = SAG
           ) -> Optional[float]:
    """The largest movement (mm) by which smoothing gives way to sizes; None where it does not."""
    if mostly_short(V, F, edges, parameters):
        return None
    made = smooth_target(V, F, parameters, job)
    largest = max(made.move, default=0.0)
    return float(largest) if largest > 0 and _sizes_do(made.V, F, edges, parameters, job, sag) else None


def mending(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job,
            sag: float = SAG) -> Optional[float]:
    """By how much (mm) mend=on would move vertices of a target on which something is in the way so that
    sizes do by estimates, `sag` as sizes_do has it; None: it is on, or it would not help."""
    if parameters.get("mend") == "on":
        return None
    return _mends(V, F, edges, parameters, Job(lambda _, fraction: job("trying mend=on", fraction)), sag)


def _sizes_do(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job, sag: float) -> bool:
    def obstacles(V: np.ndarray) -> tuple[Feasibility, list[Obstacle]]:
        found = _margins(V, F, edges, parameters, 0, sag)
        return found, [one for one in found.blocked if one.obstacle != "closed"]

    if mostly_short(V, F, edges, parameters):
        return False
    found, blocked = obstacles(V)
    if blocked and not {one.obstacle for one in blocked} & {"fold", "overlap"}:
        # Vertices of tiles that touch one with a small pin move: an obstacle that has none of them stays.
        near = np.isin(F, F[(found.pin_area_margin < 0).any(axis=1)]).any(axis=1)
        moving = np.isin(F, F[near]).any(axis=1)
        clearance = found.membrane_clearance.min(initial=np.inf)
        if (not all(moving[one.tile] for one in blocked) or (found.pin_area_margin < 0).mean() > MOST_SMALL
                or clearance < sag * parameters.get("H_pin") - MOST_CLEARED * found.L):
            return False
        there, moved = smooth_for_pins(V, F, edges, parameters, job)
        return bool(moved) and not obstacles(there)[1]
    return not blocked


def _margins(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, reached: int,
             sag: float = SAG) -> Feasibility:
    margins = native.tile_margins(V, F, edges, parameters)
    maps = native.target_fields(V, F, edges, parameters)
    count, contacts = len(F), np.asarray(margins.contacts)
    if margins.shaped:
        pin_area, share = np.asarray(margins.pin_area), np.asarray(margins.interface_share)
    else:
        pin_area, share = np.full((count, 2), np.nan), np.full(len(contacts), np.nan)
    dihedral_margin = np.asarray(margins.dihedral_margin)
    least_dihedral_margin = np.full(count, np.inf)
    for side in range(2):
        np.minimum.at(least_dihedral_margin, contacts[:, side], dihedral_margin)
    least_dihedral_margin[np.isinf(least_dihedral_margin)] = np.nan
    stretch = np.asarray(maps["conformal_stretch"])
    overlapping = np.array(margins.overlapping, np.int32).reshape(-1, 2)
    meeting = _meeting(V, F, edges, parameters, overlapping) if margins.shaped else overlapping
    clearance = np.asarray(margins.membrane_clearance) if margins.shaped else np.full((count, 2), np.nan)
    ranges = np.stack([maps["least_stretch"], maps["most_stretch"]], axis=1)
    blocked = [_obstacle("fold", tile) for tile in np.flatnonzero(margins.back_scale < 1e-3)]
    blocked += [*_without_pins(pin_area, parameters.get("A_pin_floor")), *_overlapping(overlapping),
                *_facing(meeting)]
    blocked += [_obstacle("closed.tile", tile) for tile in np.flatnonzero(np.isnan(stretch))]
    blocked += [*cut_by_membranes(clearance, sag * parameters.get("H_pin")),
                *_badly_stretched(stretch, ranges)]
    return Feasibility(
        V, F, float(native.mean_edge_length(V, F)), tuple(sorted(blocked, key=lambda one: one.tile)),
        contacts, np.asarray(margins.dihedral), dihedral_margin, least_dihedral_margin,
        np.asarray(margins.back_scale), share, pin_area - parameters.get("A_pin_min"), clearance,
        stretch, ranges, np.array(margins.trimmed, np.int32).reshape(-1, 2), overlapping, meeting,
        reached)


def _obstacle(kind: str, tile: int, certain: bool = True, **figures: Any) -> Obstacle:
    return Obstacle(Finding.about(kind, [tile], **figures), certain)


def _without_pins(area: np.ndarray, floor: float) -> Iterator[Obstacle]:
    with np.errstate(invalid="ignore"):
        small = np.argwhere((area < floor) | (area <= 0))
    for tile, side in small:
        yield _obstacle("pin", tile, side=_SIDES[side], area=float(area[tile, side]), least=floor)


def _overlapping(pairs: np.ndarray) -> Iterator[Obstacle]:
    for a, b in (*pairs, *pairs[:, ::-1]):
        yield _obstacle("overlap.bodies", a, other=(int(b),))


def _meeting(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, others: np.ndarray
             ) -> np.ndarray:
    """Pairs whose pins meet, but for those whose bodies do."""
    known = {tuple(sorted(pair)) for pair in others.tolist()}
    pairs = [pair for pair in native.facing_pins(V, F, edges, parameters) if tuple(pair) not in known]
    return np.array(pairs, np.int32).reshape(-1, 2)


def _facing(pairs: np.ndarray) -> Iterator[Obstacle]:
    for a, b in (*pairs, *pairs[:, ::-1]):
        yield _obstacle("overlap.pins", a, certain=False, other=(int(b),))


def cut_by_membranes(clearance: np.ndarray, least: float) -> Iterator[Obstacle]:
    with np.errstate(invalid="ignore"):
        low = np.argwhere(clearance < least)
    for tile, side in low:
        yield _obstacle("membrane.room", tile, certain=False, side=_SIDES[side], least=least,
                        room=float(clearance[tile, side]))


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
    return examine(V, F, edges, inputs.parameters, job)


STAGE = Stage("feasibility", ("target", "target smoothing", "division"),
              frozenset({"target", "tiles", "layout", "repair"}), _run,
              label="Feasibility", asked_by=("check",), shown=True)
