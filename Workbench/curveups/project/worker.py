# SPDX-License-Identifier: LGPL-2.1-or-later
"""One worker for all that takes longer than a blink, so that a window stays alive meanwhile.

Nothing of Qt in here: who started work asks `status()` as often as it likes, and `poll()` calls it back
in its own thread once the work has ended. Results are values, so handing them over needs no care.

Python collects garbage in whichever thread makes enough new objects. Widgets that end elsewhere are handed to
the window's thread, which deletes them later: those that their parents have deleted meanwhile once more, and
FreeCAD crashes. While a thread of this works, `poll()` is therefore what collects.
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
    """Where work is. what: is being done, empty where the stage has not said it. fraction: of that, negative
    where unknown. iterate: the newest layout. count: of iterates so far."""

    stage: str = ""
    what: str = ""
    fraction: float = -1.0
    seconds: float = 0.0
    iterate: Optional[Iterate] = None
    count: int = 0
    stopping: bool = False


@dataclass(frozen=True)
class Outcome:
    """How work ended: with a value, an error, or neither where it was cancelled or stopped before there
    was anything worth keeping."""

    value: Any = None
    error: Optional[Exception] = None
    cancelled: bool = False


OnDone = Callable[[Outcome], object]


class _Run(threading.Thread):
    """One piece of work on a thread of its own."""

    def __init__(self, work: Work, on_done: OnDone, before: Optional["_Run"]):
        super().__init__(name="CurveUps", daemon=True)
        self.on_done = on_done
        self.cancelled = False
        self.outcome: Optional[Outcome] = None
        self.job = Job(self._progress, self._listen)
        self._work, self._before = work, before
        self._began, self._ended = time.perf_counter(), 0.0
        self._said = ("", "", -1.0)  # in which stage, what, how far
        self._iterate: Optional[Iterate] = None
        self._count = 0

    def run(self) -> None:
        if self._before is not None:  # cancelled, but its native call may still be ending
            self._before.join()
            self._before = None
        try:
            with translated():
                found = Outcome(self._work(self.job))
        except Stopped:
            found = Outcome()
        except Exception as error:
            found = Outcome(error=error)
        except BaseException as error:  # a thread has nobody else to tell
            found = Outcome(error=CurveUpsError(f"unexpected {type(error).__name__}", "", "please report it"))
        # The job and this hold one another: results would stay until Python collects garbage, a long pause.
        self.job.progress = self.job.listen = None
        del self._work
        self._ended = time.perf_counter()
        self.outcome = found

    def status(self) -> Status:
        stage, what, fraction = self._said
        if stage != self.job.stage:  # it has said nothing yet, and what was said before holds no more
            what, fraction = "", -1.0
        seconds = (self._ended or time.perf_counter()) - self._began
        return Status(self.job.stage, what, fraction, seconds, self._iterate, self._count, self.job.stopped)

    def _progress(self, what: str, fraction: float) -> bool:
        self._said = self.job.stage, what, fraction
        return True

    def _listen(self, stage: str, T: np.ndarray, q: np.ndarray, figure: float, violation: float) -> None:
        self._iterate = T, q
        self._count += 1


_COLLECTING: set["Worker"] = set()  # those with a thread: while there are any, Python collects nothing itself


class Worker:
    """Does one thing at a time. All its methods are for one thread, a window's, and answer at once."""

    def __init__(self) -> None:
        self._current: Optional[_Run] = None
        self._last: Optional[_Run] = None  # that may still be ending
        self._status = Status()

    @property
    def busy(self) -> bool:
        """Whether there is work whose end has not been told yet."""
        return self._current is not None

    @property
    def settled(self) -> bool:
        """Whether nothing more is to be polled for."""
        return not self.busy and self not in _COLLECTING

    def start(self, project: Project, goals: Sequence[str], on_done: OnDone) -> None:
        """Makes the goals on a copy of the project, so that cancelling leaves nothing behind. on_done gets
        the Results as outcome's value: `stopped` says whether they are the best so far."""
        self.start_work(partial(project.copy().run, goals), on_done)

    def start_work(self, work: Work, on_done: OnDone) -> None:
        """Any work that takes a Job. Raises CurveUpsError where there is work already."""
        if self._current is not None:
            raise CurveUpsError("CurveUps is at work already", "", "stop or cancel that first")
        before = self._last if self._is_alive() else None
        gc.disable()
        _COLLECTING.add(self)
        self._current = self._last = _Run(work, on_done, before)
        self._current.start()

    def stop(self) -> None:
        """Ends the work with the best so far; on_done gets it."""
        if self._current is not None:
            self._current.job.stopped = True

    def cancel(self) -> None:
        """Ends the work with nothing: the next poll tells so, even if its thread needs a while longer."""
        if self._current is not None:
            self._current.cancelled = self._current.job.stopped = True

    def status(self) -> Status:
        """Where the work is, or where the last one ended."""
        if self._current is not None:
            self._status = self._current.status()
        return self._status

    def poll(self) -> None:
        """Calls on_done once the work has ended, from here."""
        self._collect()
        run = self._current
        if run is None:
            return
        found = Outcome(cancelled=True) if run.cancelled else run.outcome
        if found is None:
            return
        self.status()
        self._current = run.outcome = None
        run.on_done(found)

    def wait(self, seconds: float = 10.0) -> bool:
        """Waits until no thread of it runs; whether that is so. Tells nobody."""
        if self._last is not None:
            self._last.join(seconds)
        return not self._is_alive()

    def _is_alive(self) -> bool:
        return self._last is not None and self._last.is_alive()

    def _collect(self) -> None:
        """What Python would collect; Python goes on with it once no thread is left."""
        if self not in _COLLECTING:
            return
        if self._current is None and not self._is_alive():
            _COLLECTING.discard(self)
            if not _COLLECTING:
                gc.enable()
            return
        full = [generation for generation, (count, most) in enumerate(zip(gc.get_count(), gc.get_threshold()))
                if count > most > 0]
        if full:
            gc.collect(full[-1])


WORKER = Worker()  # of the window's commands
