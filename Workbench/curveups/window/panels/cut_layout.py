# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layout that follows cuts: that of Solve, before its repair, for the eye only."""

from __future__ import annotations

import time
from typing import Any, Callable, Optional

import numpy as np

from ...stages.cut_request import CutRequest
from ...stages.stage import Job
from ..qt import translate
from ..run import LIVE, Task


class CutLayout:
    """Of a Design whose project has a target, mended where that is asked for."""

    def __init__(self, design: Any, project: Any):
        self._design, self._project = design, project
        V, F = np.asarray(project.latest("target smoothing").V), np.asarray(project.latest("target").F)
        finished = project.latest("design")
        has_layout = finished is not None and np.array_equal(finished.design.F, F)
        # Layouts stay where the camera looks: at the one before, else at the target.
        self._middle = (finished.design.T if has_layout else V[F][..., :2]).mean((0, 1))
        self._last: Optional[tuple[np.ndarray, np.ndarray]] = None
        self.seconds, self.restarting = 0.0, False

    def start(self, edges: np.ndarray, done: Callable[[], None]) -> None:
        """With these cuts, C x 2, and those of pieces. What runs of it already is dropped. done is called in
        the window's thread, after the run's end."""
        if LIVE.runs_on(self._design):
            self.restarting = True
            try:
                LIVE.cancel()
            finally:
                self.restarting = False
        begun, twin = time.perf_counter(), self._project.copy()
        twin.give("cut request", CutRequest(edges=np.asarray(edges, np.int32).reshape(-1, 2)))

        def work(job: Job) -> Any:
            listen = job.listen
            if listen is not None:
                tell = listen
                job.listen = lambda stage, T, *others: tell(stage, self._in_sight(T), *others)
            design = twin.run(("layout",), job)["layout"].design
            return self._in_sight(design.T), design.q

        def finish(design: Any, value: Any) -> None:
            self._last = value
            self.seconds = time.perf_counter() - begun

        LIVE.start(self._design, Task(translate("CurveUps_Cuts", "Lay out"), work, finish, told=done))

    def show(self, overlay: Any) -> None:
        """Draws the last one."""
        if self._last is not None:
            overlay.set_iterate(*self._last)

    def _in_sight(self, T: np.ndarray) -> np.ndarray:
        return T + (self._middle - T.mean((0, 1)))
