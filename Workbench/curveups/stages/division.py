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
from .stage import Inputs, Job, Result, Row, Stage, digest

MOST_TRIED = 12    # numbers of pieces that auto tries
LEAST_TILES = 12   # of a piece, on average: native divide_surface raises for more pieces


@dataclass(frozen=True)
class Division(Result):
    """edges: C x 2 vertices of the target, all cuts: given ones, borders of pieces, slits. given: C' x 2.
    piece: M, from 0."""

    edges: np.ndarray
    given: np.ndarray
    piece: np.ndarray
    asked: str = "1"
    warned: tuple[Finding, ...] = ()

    @property
    def content(self) -> str:
        return digest(self.edges, self.given)

    def rows(self, seconds: float) -> Sequence[Row]:
        return () if self.asked == "1" else (Row("pieces", seconds),)


def all_cuts(request: CutRequest, V: np.ndarray, F: np.ndarray, parameters: Any, job: Job) -> np.ndarray:
    """All cuts of a target, C x 2: given ones, borders of pieces, slits."""
    return _divide(resolve_cuts(request, V, F), V, F, parameters, job).edges


def _divide(given: np.ndarray, V: np.ndarray, F: np.ndarray, parameters: Any, job: Job) -> Division:
    asked = parameters.get("pieces")
    if asked == "1":
        return Division(given, given, np.zeros(0, np.int32))
    if asked != "auto":
        return _divided(given, V, F, int(asked), asked, job)
    best: Optional[Division] = None
    least = np.inf
    for count in range(1, min(MOST_TRIED, max(1, len(F) // LEAST_TILES)) + 1):
        job(f"dividing into {count} piece{'s' if count > 1 else ''}")
        division = (Division(given, given, native.pieces_of_faces(V, F, given), asked) if count == 1
                    else _divided(given, V, F, count, asked, job))
        share = _worst(division, V, F, parameters)
        if share < least:
            best, least = division, share
        if share == 0:
            break
    if best is None or not np.isfinite(least):
        raise CurveUpsError(f"no division into up to {MOST_TRIED} pieces lies flat", "pieces=auto",
                            "set pieces to a number, or cut the target (--cuts)")
    if least > 0:
        return _warned(best, "pieces.stretched", most=MOST_TRIED, count=_count(best))
    return best


def _divided(given: np.ndarray, V: np.ndarray, F: np.ndarray, count: int, asked: str,
             job: Job) -> Division:
    with translated(f"pieces={asked}"):
        pieces = native.divide_surface(V, F, given, count, job)
    edges = np.vstack([given, pieces.borders, pieces.slits]).astype(np.int32).reshape(-1, 2)
    division = Division(np.array(sorted(map(tuple, edges.tolist())), np.int32).reshape(-1, 2), given,
                        np.asarray(pieces.piece, np.int32), asked)
    if _count(division) == count or asked == "auto":
        return division
    return _warned(division, "pieces", count=_count(division), asked=count)


def _warned(division: Division, kind: str, **figures: Any) -> Division:
    return replace(division, warned=(Finding.about(kind, **figures),))


def _count(division: Division) -> int:
    return int(division.piece.max(initial=-1)) + 1


def _worst(division: Division, V: np.ndarray, F: np.ndarray, parameters: Any) -> float:
    """Largest share of a piece's tiles that the flat map stretches too far; infinite where a piece has no
    flat map."""
    figures = native.target_figures(V, F, division.edges, parameters)
    stretch = np.asarray(figures.stretch)
    if np.isnan(stretch).any():
        return np.inf
    ranges = np.stack([figures.least_stretch, figures.most_stretch], axis=1)
    pieces = (division.piece == number for number in range(_count(division)))
    return max(float(too_stretched(stretch[own], ranges[own]).mean()) for own in pieces)


def _run(inputs: Inputs, job: Job) -> Division:
    V, F = inputs["target smoothing"].V, inputs["target"].F
    return _divide(resolve_cuts(inputs["cut request"], V, F), V, F, inputs.parameters, job)


def _parts(parameters: Any) -> frozenset[str]:
    """Readers of the parameters; auto alone estimates the stretch of membranes."""
    return frozenset({"pieces", "tiles", "layout"} if parameters.get("pieces") == "auto" else {"pieces"})


STAGE = Stage("division", ("target", "target smoothing", "cut request"), _parts, _run,
              label="Pieces", asked_by=("solve",))


@dataclass(frozen=True)
class Cuts(Result):
    """edges: C x 2 vertex pairs of the target, each once, ascending."""

    edges: np.ndarray

    @property
    def content(self) -> str:
        return digest(self.edges)


def _check(inputs: Inputs, job: Job) -> Cuts:
    V, F = inputs["target smoothing"].V, inputs["target"].F
    edges = inputs["division"].edges
    require_no_error(native.check_target(V, F, edges, inputs.parameters), inputs.where)
    return Cuts(edges)


CUTS = Stage("cuts", ("target", "target smoothing", "division"), frozenset({"tiles"}), _check,
             label="Cuts", asked_by=("solve",), shown=True)
