# SPDX-License-Identifier: LGPL-2.1-or-later
"""Describes each piece of a design: its tiles, its forces, and whether it holds by itself."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..base.findings import Finding
from ..base.native import native
from .cut_request import interior_edges
from .stage import Block, Inputs, Job, Stage


def _run(inputs: Inputs, job: Job) -> Block:
    """Block of report.json: pieces in the order of their lowest tiles, as files and labels number them; empty
    for one piece. A piece's `valid` and `reasons` count those of the whole design, too."""
    design, verification = inputs["design"].design, inputs["verification"]
    piece = np.asarray(native.pieces_of_faces(design.V, design.F, design.cuts))
    count = int(piece.max(initial=0)) + 1
    if count == 1:
        return Block("pieces")
    corners = design.V[design.F]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1) / 200  # cm2
    cut = {(min(pair), max(pair)) for pair in design.cuts.tolist()}
    pairs = np.asarray(verification.arrays.get("contact_tiles", ()), int).reshape(-1, 2)
    reasons_of_all = (*inputs["figures"].reasons(), *verification.reasons())
    judged = verification.judged and not verification.failure
    pieces: list[dict[str, Any]] = []
    weak: list[Finding] = []
    for number in range(count):
        tiles, contacts = np.flatnonzero(piece == number), np.flatnonzero(piece[pairs[:, 0]] == number)
        reasons = [reason for reason in reasons_of_all if reason.concerns(tiles.tolist())]
        mean = least = f_min = None
        if len(contacts):
            mean = float(verification.arrays["contact_normal_mean"][contacts].mean())
            normal = verification.arrays["contact_normal_min"][contacts]
            least, f_min = float(normal.min()), inputs.parameters.get("f_min_ratio") * max(0.0, mean)
            # A piece of its own has to hold by its own mean force, which may exceed that of all pieces.
            of_all = max(0.0, verification.blocks["contact_forces"]["f_min"])
            if inputs.parameters.get("pieces") != "1" and judged and of_all <= least < f_min:
                a, b = pairs[contacts[normal.argmin()]].tolist()
                weak.append(Finding.about("piece_weak", (a, b), piece=number + 1, contact=((a, b),),
                                          least=least, f_min=f_min))
                reasons.append(weak[-1])
        pieces.append({"piece": number + 1, "first_tile": int(tiles[0]), "tiles": len(tiles),
                       "contacts": len(interior_edges(design.F[tiles]) - cut),
                       "actuated_cm2": float(area[tiles].sum()), "normal_mean": mean, "normal_min": least,
                       "f_min": f_min, "valid": not reasons if judged else None,
                       "reasons": list(map(str, reasons))})
    return Block("pieces", pieces, broken=tuple(weak))


STAGE = Stage("pieces", ("design", "figures", "verification"), frozenset({"pieces", "physics"}), _run,
              on_stop=lambda stage, inputs: Block("pieces"),
              label="Pieces", commands=("solve", "verify"), judges=True)
