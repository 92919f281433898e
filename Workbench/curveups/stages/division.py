# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts of the target, and its division into pieces where it can't lie flat as a whole: closed surfaces,
handles, much stretch. Pieces are separated by cuts along their borders; slits let each lie flat."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, require_no_error
from ..base.native import native, translated
from .cut_request import CutRequest, resolve_cuts
from .feasibility import too_stretched
from .stage import Inputs, Job, Result, Row, Stage

MOST_TRIED = 12    # numbers of pieces that auto tries
LEAST_TILES = 12   # of a piece, on average: native divide_surface raises for more pieces


@dataclass(frozen=True)
class Division(Result):
    """edges: C x 2 vertices of the target, all cuts: given ones, borders of pieces, slits. given: C' x 2.
    piece: M, from 0."""

    read_later = ("edges", "given")
    edges: np.ndarray
    given: np.ndarray
    piece: np.ndarray
    requested: str = "1"
    warned: tuple[Finding, ...] = ()

    @property
    def count(self) -> int:
        """Number of pieces."""
        return int(self.piece.max(initial=-1)) + 1

    def rows(self, seconds: float) -> Sequence[Row]:
        return () if self.requested == "1" else (Row("pieces", seconds),)


def all_cuts(request: CutRequest, V: np.ndarray, F: np.ndarray, parameters: Any, job: Job) -> np.ndarray:
    """All cuts of a target, C x 2: given ones, borders of pieces, slits."""
    return _divide(resolve_cuts(request, V, F), V, F, parameters, job).edges


def _divide(given: np.ndarray, V: np.ndarray, F: np.ndarray, parameters: Any, job: Job) -> Division:
    requested = parameters.get("pieces")
    if requested == "1":
        return Division(given, given, np.zeros(0, np.int32))
    if requested != "auto":
        return _divided(given, V, F, int(requested), requested, job)
    best: Optional[Division] = None
    least = np.inf
    for count in range(1, min(MOST_TRIED, max(1, len(F) // LEAST_TILES)) + 1):
        job(f"dividing into {count} piece{'s' if count > 1 else ''}")
        division = (Division(given, given, native.pieces_of_faces(V, F, given), requested) if count == 1
                    else _divided(given, V, F, count, requested, job))
        share = _worst(division, V, F, parameters)
        if share < least:
            best, least = division, share
        if share == 0:
            break
    if best is None or not np.isfinite(least):
        raise CurveUpsError(f"no division into up to {MOST_TRIED} pieces lies flat", "pieces=auto",
                            "set pieces to a number, or cut the target (--cuts)")
    if least > 0:
        return replace(best, warned=(Finding.about("pieces.stretched", most=MOST_TRIED, count=best.count),))
    return best


def _divided(given: np.ndarray, V: np.ndarray, F: np.ndarray, count: int, requested: str,
             job: Job) -> Division:
    with translated(f"pieces={requested}"):
        pieces = native.divide_surface(V, F, given, count, job)
    edges = np.vstack([given, pieces.borders, pieces.slits]).astype(np.int32).reshape(-1, 2)
    division = Division(np.array(sorted(map(tuple, edges.tolist())), np.int32).reshape(-1, 2), given,
                        np.asarray(pieces.piece, np.int32), requested)
    if division.count == count or requested == "auto":
        return division
    return replace(division, warned=(Finding.about("pieces", count=division.count, asked=count),))


def _worst(division: Division, V: np.ndarray, F: np.ndarray, parameters: Any) -> float:
    """Largest share of a piece's tiles that the flat map stretches too far; infinite where a piece has no
    flat map."""
    figures = native.target_figures(V, F, division.edges, parameters)
    stretch = np.asarray(figures.stretch)
    if np.isnan(stretch).any():
        return np.inf
    ranges = np.stack([figures.least_stretch, figures.most_stretch], axis=1)
    pieces = (division.piece == number for number in range(division.count))
    return max(float(too_stretched(stretch[own], ranges[own]).mean()) for own in pieces)


def _run(inputs: Inputs, job: Job) -> Division:
    V, F = inputs["target smoothing"].V, inputs["target"].F
    request = inputs["cut request"]
    edges = resolve_cuts(request, V, F)
    if request.divided and inputs.parameters.get("pieces") != "1":
        return Division(edges, edges, native.pieces_of_faces(V, F, edges), inputs.parameters.get("pieces"))
    return _divide(edges, V, F, inputs.parameters, job)


def _parts(parameters: Any) -> frozenset[str]:
    """Readers of the parameters; auto alone estimates the stretch of membranes."""
    return frozenset({"pieces", "tiles", "layout"} if parameters.get("pieces") == "auto" else {"pieces"})


STAGE = Stage("division", ("target", "target smoothing", "cut request"), _parts, _run,
              label="Pieces", commands=("solve",))


@dataclass(frozen=True)
class Cuts(Result):
    """edges: C x 2 vertex pairs of the target, each once, ascending."""

    read_later = ("edges",)
    edges: np.ndarray


def _check(inputs: Inputs, job: Job) -> Cuts:
    V, F = inputs["target smoothing"].V, inputs["target"].F
    edges = inputs["division"].edges
    require_no_error(native.check_target(V, F, edges, inputs.parameters), inputs.where)
    return Cuts(edges)


CUTS = Stage("cuts", ("target", "target smoothing", "division"), frozenset({"tiles"}), _check,
             label="Cuts", commands=("solve",), shown=True)
