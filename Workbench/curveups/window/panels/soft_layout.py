# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quick layout that follows cuts: soft terms alone, from the layout before, for the eye only."""

from __future__ import annotations

import time
from typing import Any, Callable, Optional

import numpy as np

from ...base.native import native
from ...stages.cut_request import CutRequest
from ...stages.division import all_cuts
from ...stages.stage import Job
from ..qt import translate
from ..run import LIVE, Task

_NONE = np.zeros((0, 2), np.int32)
_ITERATIONS = 25  # of the most; pictures have settled by then


class SoftLayout:
    """Of a Design whose project has a target, mended where that is asked for."""

    def __init__(self, design: Any, project: Any):
        self._design = design
        target, finished = project.latest("target"), project.latest("design")
        self._V, self._F = np.asarray(project.latest("fairing").V), np.asarray(target.F)
        self._parameters = project.parameters
        for name, value in target.settles().items():
            self._parameters.set(name, value)
        self._last: Optional[tuple[np.ndarray, np.ndarray]] = None  # where the next one starts from
        if finished is not None and np.array_equal(finished.design.F, self._F):
            self._last = np.asarray(finished.design.T), np.asarray(finished.design.q)
        # Layouts stay where the camera looks: at the one before, else at the target.
        self._middle = (self._V[self._F][..., :2] if self._last is None else self._last[0]).mean((0, 1))
        self.weak: list[tuple[int, int]] = []  # pairs of tiles
        self.seconds, self.shown, self.restarting = 0.0, False, False

    def start(self, edges: np.ndarray, done: Callable[[], None]) -> None:
        """With these cuts, C x 2, and those of pieces. What runs of it already is dropped. done is called in
        the window's thread, after the run's end."""
        if LIVE.runs_on(self._design):
            self.restarting = True
            try:
                LIVE.cancel()
            finally:
                self.restarting = False
        begun, last = time.perf_counter(), self._last
        request = CutRequest(edges=np.asarray(edges, np.int32).reshape(-1, 2))

        def work(job: Job) -> Any:
            job.stage = "soft layout"
            start = None if last is None else self._as_design(*last, _NONE)
            listener = job.listener("soft layout")

            def tell(T: np.ndarray, *others: Any) -> bool:
                return listener is None or listener(self._in_sight(T), *others)

            edges = all_cuts(request, self._V, self._F, self._parameters, job)
            found = native.solve_soft_layout(self._V, self._F, edges, self._parameters, start, _ITERATIONS,
                                             job, tell)
            fields = native.design_fields(self._as_design(found.T, found.q, edges))
            pairs = fields["contact_tiles"][fields["weak"]]
            return self._in_sight(found.T), found.q, [(int(a), int(b)) for a, b in pairs]

        def finish(design: Any, value: Any) -> None:
            T, q, self.weak = value
            self._last = T, q
            self.seconds = time.perf_counter() - begun

        LIVE.start(self._design, Task(translate("CurveUps_Cuts", "Lay out"), work, finish, told=done))

    def show(self, overlay: Any) -> None:
        """Draws the last one."""
        if self._last is not None:
            overlay.set_iterate(*self._last)
            self.shown = True

    def _in_sight(self, T: np.ndarray) -> np.ndarray:
        return T + (self._middle - T.mean((0, 1)))

    def _as_design(self, T: np.ndarray, q: np.ndarray, edges: np.ndarray) -> Any:
        return native.Design("soft", self._parameters, self._V, self._F, T, q, edges)
