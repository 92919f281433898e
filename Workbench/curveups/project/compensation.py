# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves the surface of a design against the shape in which it settles, so that the finished piece meets the
target: where a corner settles beside its place, the surface is moved the other way by as much, and laid out,
repaired and settled again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from ..base.native import native
from ..stages.stage import Job


@dataclass(frozen=True)
class Compensation:
    """design: native Design, the best of all rounds; the given one where none is better. mean, largest: mm
    from where tiles' front corners settle to their places on the target, turned and moved to fit it; of the
    design as it was given, then of each round. kept: the round whose design this is, 0 for none. Rounds end
    early where a design is no longer valid or does not settle."""

    design: Any
    mean: tuple[float, ...]
    largest: tuple[float, ...]
    kept: int

    @property
    def said(self) -> str:
        """How much nearer the shape comes."""
        return (f"settles {self.mean[0]:.3f} mm beside the target in the mean, {self.mean[self.kept]:.3f} mm "
                f"after round {self.kept}" if self.kept else
                f"settles {self.mean[0]:.3f} mm beside the target in the mean; no round comes nearer")

    def report(self) -> dict[str, Any]:
        return {"mean_mm": list(self.mean), "max_mm": list(self.largest), "kept_round": self.kept}


def compensate(design: Any, rounds: int, job: Job) -> Compensation:
    """Raises Stopped or native.Cancelled where `job` is stopped, CurveUpsError where the design itself does
    not settle, and what laying out and settling raise."""
    faces, wanted = np.asarray(design.F), np.asarray(_target_of(design)[0])
    corner, on_target = faces.reshape(-1), wanted[faces].reshape(-1, 3)
    count = np.bincount(corner, minlength=len(wanted))[:, None]
    aim, best, kept = np.array(wanted), design, 0
    mean: list[float] = []
    largest: list[float] = []
    for number in range(rounds + 1):
        if number:
            made, valid = _relaid(design, aim, job)
            design = made if valid else None
        settled = native.settle_design(design, progress=job) if design is not None else None
        if job.stopped:
            raise Stopped
        if settled is None or settled.holds is None:
            break
        corners = np.asarray(settled.corners).reshape(-1, 3)
        R, t = rigid_motion(corners, on_target)
        off = on_target - (corners @ R.T + t)
        distance = np.linalg.norm(off, axis=1)
        if not mean or distance.mean() < min(mean):
            best, kept = design, number
        mean.append(float(distance.mean()))
        largest.append(float(distance.max()))
        move = np.zeros_like(aim)
        np.add.at(move, corner, off)
        aim += move / count
    if not mean:
        raise CurveUpsError("where its tiles settle could not be found", design.name,
                            "leave --compensate out, or change the design")
    return Compensation(best, tuple(mean), tuple(largest), kept)


def _target_of(design: Any) -> Any:
    """V and F of the target, where its triangles are those of the design; else the design's own."""
    given = design.target
    return given if given is not None and np.array_equal(given[1], design.F) else (design.V, design.F)


def _relaid(design: Any, surface: np.ndarray, job: Job) -> tuple[Any, bool]:
    """A design of the same target and triangles on `surface` (N x 3, mm), laid out and repaired; and whether
    it is valid. Raises what the native functions raise."""
    layout = native.solve_layout(surface, design.F, design.cuts, design.parameters, job)
    laid = native.Design(design.name, design.parameters, surface, design.F, layout.T, layout.q, design.cuts,
                         _target_of(design))
    repaired = native.repair_design(laid, progress=job)
    return repaired.design, repaired.status == "valid"


def rigid_motion(source: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """R, t with the least sum of squares of R x + t - y over pairs of points, n x 3 (Kabsch, Acta
    Cryst. A 32, 1976)."""
    a, b = source.mean(0), target.mean(0)
    u, _, vt = np.linalg.svd((target - b).T @ (source - a))
    R = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    return R, b - R @ a
