# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges across which tiles are disconnected."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.findings import settle
from ..base.native import native
from .stage import Inputs, Job, Result, Stage, digest


@dataclass(frozen=True)
class Cuts(Result):
    """edges: C x 2 vertex pairs of the target, each once, ascending."""

    edges: np.ndarray

    @property
    def content(self) -> str:
        return digest(self.edges)


def _run(inputs: Inputs, job: Job) -> Cuts:
    V, F = inputs["target smoothing"].V, inputs["target"].F
    edges = inputs["division"].edges
    errors = [one for one in native.check_target(V, F, edges, inputs.parameters) if one.is_error]
    settle(errors, inputs.where)
    return Cuts(edges)


STAGE = Stage("cuts", ("target", "target smoothing", "division"), frozenset({"tiles"}), _run,
              label="Cuts", asked_by=("solve",), shown=True)
