# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coarse optimisation: flat poses and pins (Eq. 9 under hard constraints)."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence

from ..base.findings import Finding
from ..base.native import native
from .design import DesignResult
from .stage import Inputs, Job, Row, Stage


@dataclass(frozen=True)
class Layout(DesignResult):
    """The design after layout."""

    was_stopped: bool
    block: Mapping[str, Any]  # of report.json
    flatten_seconds: float    # up to the first step

    @property
    def converged(self) -> bool:
        return bool(self.block["converged"])

    @property
    def unsettled(self) -> Optional[Finding]:
        """Reason for doubt where the optimiser did not converge; or None."""
        if self.converged or self.was_stopped:
            return None
        return Finding.about("unsettled", iterations=self.block["iterations"])

    def report(self) -> dict[str, Any]:
        return {"layout": dict(self.block)}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("flatten", self.flatten_seconds),
                Row("layout", seconds - self.flatten_seconds, self.block["iterations"]))


def _run(inputs: Inputs, job: Job) -> Layout:
    target, smoothed, edges = inputs["target"], inputs["pin smoothing"], inputs["cuts"].edges
    start = time.perf_counter()
    first: list[float] = []

    def progress(what: str, fraction: float) -> bool:
        if not first:
            first.append(time.perf_counter() - start)
        return job(what, fraction)

    followed = target.followed  # of this run, or of one before
    follows = followed is not None and followed.earlier is inputs["source"].follows
    laid_out = native.solve_layout(smoothed.V, target.F, edges, inputs.parameters, progress,
                                   job.listener("layout"), followed.start if follows else None)
    moved_from = None if smoothed.moved is None else (inputs["target smoothing"].V, target.F)
    design = native.Design(inputs["source"].name, inputs.parameters, smoothed.V, target.F, laid_out.T,
                           laid_out.q, edges, moved_from)
    return Layout(design, laid_out.stopped, laid_out.block, first[0] if first else 0.0)


STAGE = Stage("layout", ("source", "target", "target smoothing", "cuts", "pin smoothing"),
              frozenset({"tiles", "layout"}), _run, label="Layout", commands=("solve",), shown=True)
