# SPDX-License-Identifier: LGPL-2.1-or-later
"""Describes each piece of a design: its tiles, its forces, and whether it holds by itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from ..base.findings import Finding, Value
from ..base.native import native
from .cut_request import interior_edges
from .stage import Inputs, Job, Result, Stage


@dataclass(frozen=True)
class Piece(Value):
    """Tiles joined by contacts. Normal forces at its contacts, N: mean, least, and f_min by the piece's own
    mean; None without verification. valid: None where the design is not judged. reasons: with those of the
    whole design."""

    first_tile: int
    tiles: int
    contacts: int
    actuated_cm2: float
    normal_mean: Optional[float] = None
    normal_min: Optional[float] = None
    f_min: Optional[float] = None
    valid: Optional[bool] = None
    reasons: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Pieces(Result):
    """Pieces in the order of their lowest tiles, as files and labels number them; empty for one piece."""

    pieces: tuple[Piece, ...] = ()
    broken: tuple[Finding, ...] = ()  # reasons besides those of the whole design

    def report(self) -> dict[str, Any]:
        if not self.pieces:
            return {}
        return {"pieces": [{"piece": number, **vars(piece), "reasons": list(map(str, piece.reasons))}
                           for number, piece in enumerate(self.pieces, 1)]}


def _run(inputs: Inputs, job: Job) -> Pieces:
    design, found = inputs["design"].design, inputs["verification"]
    piece = np.asarray(native.pieces_of_faces(design.V, design.F, design.cuts))
    count = int(piece.max(initial=0)) + 1
    if count == 1:
        return Pieces()
    corners = design.V[design.F]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1) / 200  # cm2
    said = (*inputs["figures"].reasons(), *found.reasons())
    apart = inputs.parameters.get("pieces") != "1"
    judged = found.judged and not found.failure
    pieces: list[Piece] = []
    weak: list[Finding] = []
    for number in range(count):
        own = np.flatnonzero(piece == number)
        forces = _forces(found, piece, number, inputs.parameters.get("f_min_ratio"))
        mean, least, f_min = forces or (None, None, None)
        # A piece of its own has to hold by its own mean force, which may exceed that of all pieces.
        alone = _weakness(found, piece, number, forces) if apart and judged and forces else None
        weak += [alone] if alone else []
        reasons = (*(reason for reason in said if reason.concerns(own.tolist())), *([alone] if alone else []))
        pieces.append(Piece(int(own[0]), len(own), _contacts(design, piece, number), float(area[own].sum()),
                            mean, least, f_min, not reasons if judged else None, reasons))
    return Pieces(tuple(pieces), tuple(weak))


def _contacts(design: Any, piece: np.ndarray, number: int) -> int:
    """Number of edges between two tiles of the piece that are not cut."""
    cut = {(min(pair), max(pair)) for pair in design.cuts.tolist()}
    return len(interior_edges(design.F[piece == number]) - cut)


def _own(found: Any, piece: np.ndarray, number: int) -> np.ndarray:
    """Indices of the contacts of a piece."""
    pairs = np.asarray(found.arrays.get("contact_tiles", ()), int).reshape(-1, 2)
    return np.flatnonzero(piece[pairs[:, 0]] == number)


def _forces(found: Any, piece: np.ndarray, number: int, ratio: float) -> Optional[tuple[float, float, float]]:
    """Mean, least and required normal force of a piece, N; None without contacts."""
    own = _own(found, piece, number)
    if not len(own):
        return None
    mean = float(np.mean(found.arrays["contact_normal_mean"][own]))
    return mean, float(np.min(found.arrays["contact_normal_min"][own])), ratio * max(0.0, mean)


def _weakness(found: Any, piece: np.ndarray, number: int, forces: tuple[float, float, float]
              ) -> Optional[Finding]:
    """Reason for which a piece does not hold by itself, though the whole design does; or None."""
    _, least, f_min = forces
    if not max(0.0, found.blocks["contact_forces"]["f_min"]) <= least < f_min:
        return None
    own = _own(found, piece, number)
    a, b = map(int, found.arrays["contact_tiles"][own[np.argmin(found.arrays["contact_normal_min"][own])]])
    return Finding.about("piece_weak", (a, b), piece=number + 1, contact=((a, b),), least=least, f_min=f_min)


STAGE = Stage("pieces", ("design", "figures", "verification"), frozenset({"pieces", "physics"}), _run,
              on_stop=lambda stage, inputs: Pieces(),
              label="Pieces", asked_by=("solve", "verify"), judges=True)
