# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges across which tiles are disconnected."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.findings import settle
from ..base.native import native
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
    V, F = inputs["target smoothing"].V, inputs["target"].F
    edges = inputs["division"].edges
    errors = [one for one in native.check_target(V, F, edges, inputs.parameters) if one.is_error]
    with with_advice(inputs, inputs["cut request"], job):
        settle([error for error in errors if not error.kind.startswith("joint.")], inputs.where)
    settle(errors, inputs.where)  # other sizes are tried without stitching holes
    return Cuts(edges)


STAGE = Stage("cuts", ("target", "target smoothing", "cut request", "division"), frozenset({"tiles"}), _run,
              label="Cuts", asked_by=("solve",), shown=True)
