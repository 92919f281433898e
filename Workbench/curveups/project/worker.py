# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worker thread for long work, so that a window stays responsive. Without Qt: the window's thread asks
`status()`, and `poll()` calls back there once the work has ended.

If the garbage collector frees a widget on the worker's thread, Qt may delete it twice and crash FreeCAD.
Automatic collection is therefore off while a worker runs, and `poll()` collects.
"""

from __future__ import annotations

import gc
import threading
import time
from dataclasses import dataclass
from functools import partial
from typing import Any, Callable, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from ..base.native import translated
from ..stages.stage import Job
from .project import Project

Iterate = tuple[np.ndarray, np.ndarray]  # flat corners, insets
Work = Callable[[Job], Any]


@dataclass(frozen=True)
class Status:
    """Progress of work. what: name of the current work, or empty. fraction: of it, negative where unknown.
    iterate: the newest layout. count: number of iterates."""

    stage: str = ""
    what: str = ""
    fraction: float = -1.0
    seconds: float = 0.0
    iterate: Optional[Iterate] = None
    count: int = 0
    stopping: bool = False


@dataclass(frozen=True)
class Outcome:
    """End of work: a value, an error, or neither after it was cancelled or stopped without a result."""

    value: Any = None
    error: Optional[Exception] = None
    cancelled: bool = False


OnDone = Callable[[Outcome], object]


class _Run(threading.Thread):
    """Thread of one piece of work. turn: held by the thread that works, as a cancelled native call may still
    be ending."""

    def __init__(self, work: Work, on_done: OnDone, turn: threading.Lock):
        super().__init__(name="CurveUps", daemon=True)
        self.on_done = on_done
        self.cancelled = False
        self.outcome: Optional[Outcome] = None
        self.job = Job(self._progress, self._listen)
        self._work, self._turn = work, turn
        self._began, self._ended = time.perf_counter(), 0.0
        self._said = ("", "", -1.0)  # stage, what, fraction
        self._iterate: Optional[Iterate] = None
        self._count = 0

    def run(self) -> None:
        try:
            with self._turn, translated():
                outcome = Outcome(self._work(self.job))
        except Stopped:
            outcome = Outcome()
        except Exception as error:
            outcome = Outcome(error=error)
        # The job refers to this thread: without the cycle, results are freed at once, without a long pause.
        self.job.progress = self.job.listen = None
        del self._work
        self._ended = time.perf_counter()
        self.outcome = outcome

    def status(self) -> Status:
        stage, what, fraction = self._said
        if stage != self.job.stage:  # the report is of an earlier stage
            what, fraction = "", -1.0
        seconds = (self._ended or time.perf_counter()) - self._began
        return Status(self.job.stage, what, fraction, seconds, self._iterate, self._count, self.job.stopped)

    def _progress(self, what: str, fraction: float) -> bool:
        self._said = self.job.stage, what, fraction
        return True

    def _listen(self, stage: str, T: np.ndarray, q: np.ndarray, figure: float, violation: float) -> None:
        self._iterate = T, q
        self._count += 1


class Worker:
    """Does one piece of work at a time. Its methods belong to the window's thread and return at once."""

    def __init__(self) -> None:
        self._current: Optional[_Run] = None
        self._last: Optional[_Run] = None  # may still be ending; gc is disabled until it has ended
        self._turn = threading.Lock()
        self._status = Status()

    @property
    def busy(self) -> bool:
        """True until on_done was called."""
        return self._current is not None

    @property
    def idle(self) -> bool:
        """True where poll has nothing to do."""
        return self._last is None

    def start(self, project: Project, goals: Sequence[str], on_done: OnDone) -> None:
        """Makes the goals on a copy of the project, which cancelling leaves unchanged. on_done gets an
        Outcome whose value is the Results."""
        self.start_work(partial(project.copy().run, goals), on_done)

    def start_work(self, work: Work, on_done: OnDone) -> None:
        """Runs work(job). Raises CurveUpsError while there is other work."""
        if self._current is not None:
            raise CurveUpsError("CurveUps is at work already", "", "stop or cancel that first")
        gc.disable()
        self._current = self._last = _Run(work, on_done, self._turn)
        self._current.start()

    def stop(self) -> None:
        """Ends the work with the best so far."""
        if self._current is not None:
            self._current.job.stopped = True

    def cancel(self) -> None:
        """Ends the work without a result at the next poll, even while its thread is still ending."""
        if self._current is not None:
            self._current.cancelled = self._current.job.stopped = True

    def status(self) -> Status:
        """Progress of the work, or the last one before its end."""
        if self._current is not None:
            self._status = self._current.status()
        return self._status

    def poll(self) -> None:
        """Calls on_done if the work has ended."""
        self._collect()
        run = self._current
        if run is None:
            return
        outcome = Outcome(cancelled=True) if run.cancelled else run.outcome
        if outcome is None:
            return
        self.status()
        self._current = run.outcome = None
        run.on_done(outcome)

    def wait(self, seconds: float = 10.0) -> bool:
        """Waits until no thread runs, and returns whether that is so. Does not call on_done."""
        if self._last is not None:
            self._last.join(seconds)
        return self._last is None or not self._last.is_alive()

    def _collect(self) -> None:
        """Collects garbage while a thread runs, as Python would; enables gc after the last."""
        if self._last is None:
            return
        if self._current is None and not self._last.is_alive():
            self._last = None
            gc.enable()
            return
        full = [generation for generation, (count, most) in enumerate(zip(gc.get_count(), gc.get_threshold()))
                if count > most > 0]
        if full:
            gc.collect(full[-1])


WORKER = Worker()  # for the window's commands
