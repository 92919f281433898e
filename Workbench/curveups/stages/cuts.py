# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges across which tiles are disconnected."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.native import native
from .findings import settle, tiles_place
from .sizes import with_advice
from .stage import Inputs, Job, Result, Stage, digest


@dataclass(frozen=True)
class Cuts(Result):
    """edges: C x 2 vertex pairs of the target, each once, ascending."""

    edges: np.ndarray

    @property
    def content(self) -> str:
        return digest(self.edges)


def _run(inputs: Inputs, job: Job) -> Cuts:
    V, F = inputs["fairing"].V, inputs["target"].F
    edges = inputs["division"].edges
    findings = native.check_target(V, F, edges, inputs.parameters)
    with with_advice(inputs, inputs["cut request"], job):
        settle([finding for finding in findings if finding.is_error], inputs.where, tiles_place)
    return Cuts(edges)


STAGE = Stage("cuts", ("target", "fairing", "cut request", "division"), frozenset({"tiles"}), _run)
