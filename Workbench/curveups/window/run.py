# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one run of the window: started here, polled by a timer, drawn while it goes, taken over or dropped
when it ends. Panels come and go meanwhile; so may the document, and FreeCAD itself."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from typing import Any, Callable, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError
from ..features.document import has_layout, set_running
from ..features.status import has_tiles
from ..project.project import Project
from ..project.worker import WORKER, Outcome, Status
from ..stages import label_of
from ..stages.stage import Job
from .notice import errors_shown, show_error, show_line, words_of
from .overlay.cameras import active_view
from .overlay.scene import scene_of
from .overlays import overlay_of
from .panels.preferences import draws_live
from .qt import QtCore, QtWidgets, translate

INTERVAL = 40  # ms between looks at the worker
TELLING = 0.2  # s between words of how far a stage is: each has the whole window composed anew
QUIT_SECONDS = 20.0  # that FreeCAD waits for a native call to see that it is stopped


@dataclass(frozen=True)
class Task:
    """title: of the command. work: for the worker's thread; it touches no document. finish: gets what
    work made, in the window's thread. follow: what follows from that in the document, before it is drawn.
    project: that it is done on, for pictures of it. told: called once what finish has done is drawn and the
    observers know of the end."""

    title: str
    work: Callable[[Job], Any]
    finish: Callable[[Any, Any], None]  # design, value
    project: Optional[Project] = None
    told: Optional[Callable[[], None]] = None
    follow: Optional[Callable[[Any], None]] = None  # design


Observer = Callable[[Status, bool], None]  # where the run is; whether it goes on


class Live:
    """Starts tasks and tells observers. One at a time: the second is refused with a CurveUpsError."""

    def __init__(self) -> None:
        self._observers: list[Observer] = []
        self._timer: Any = None
        self._task: Optional[Task] = None
        self._place = ("", "")  # document and object that the run is for
        self._drawn, self._rest_until, self._scene_drawn = 0, 0.0, False
        self._told = ("", 0.0)  # of which stage the observers were last, and when
        self._before = False, False  # whether the design had tiles, and a layout
        self._drawing = False  # the document has the results; the picture follows

    @property
    def busy(self) -> bool:
        return WORKER.busy or self._drawing

    def obstacle(self) -> str:
        """Why nothing else can begin now; empty where it can."""
        return translate("CurveUps", "CurveUps is at work: stop or cancel that first") if self.busy else ""

    def runs_on(self, design: Any) -> bool:
        """Whether the run is this design's."""
        return self.busy and self._place == (design.Document.Name, design.Name)

    def observe(self, observer: Observer) -> None:
        self._observers.append(observer)

    def forget(self, observer: Observer) -> None:
        if observer in self._observers:
            self._observers.remove(observer)

    def start(self, design: Any, task: Task) -> None:
        """Raises CurveUpsError where something runs already."""
        if self.busy:
            raise CurveUpsError(self.obstacle())
        self._install()
        WORKER.start_work(task.work, self._ended)
        self._task, self._place = task, (design.Document.Name, design.Name)
        self._drawn, self._rest_until, self._scene_drawn = 0, 0.0, False
        self._before = has_tiles(design), has_layout(design)
        set_running(design, True)
        self._timer.start(INTERVAL)
        self._tell(True)

    def stop(self) -> None:
        """Keep the best so far."""
        WORKER.stop()
        self._tell(True)

    def cancel(self) -> None:
        """Leave the design as it was."""
        WORKER.cancel()
        WORKER.poll()

    def slotDeletedDocument(self, document: Any) -> None:
        """Of FreeCAD's document observer."""
        self._abandon(document.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        """Of FreeCAD's document observer."""
        self._abandon(obj.Document.Name, obj.Name)

    def _abandon(self, document: str, name: str = "") -> None:
        """The design, or its document, is going away: nothing of it is touched any more."""
        if self.busy and self._place[0] == document and name in ("", self._place[1]):
            self._place = ("", "")
            self.cancel()

    def quit(self) -> None:
        """FreeCAD ends: no thread may be left in the native module."""
        self._place = ("", "")
        if self._timer is not None:
            self._timer.stop()
        WORKER.cancel()
        WORKER.wait(QUIT_SECONDS)

    def _install(self) -> None:
        if self._timer is not None:
            return
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(lambda: self._look())
        FreeCAD.addDocumentObserver(self)
        QtWidgets.QApplication.instance().aboutToQuit.connect(lambda: self.quit())

    def _look(self) -> None:
        WORKER.poll()
        if WORKER.idle:
            self._timer.stop()
        if not WORKER.busy:
            return
        status, (stage, when) = WORKER.status(), self._told
        if status.stage != stage or time.perf_counter() >= when + TELLING:
            self._tell(True)
        self._draw(status)

    def _draw(self, status: Status) -> None:
        """The newest iterate; pictures that take long come more seldom."""
        design = self._design()
        if (design is None or status.iterate is None or status.count == self._drawn or status.stopping
                or not draws_live() or time.perf_counter() < self._rest_until):
            return
        start = time.perf_counter()
        self._drawn = status.count
        T, q = status.iterate
        with errors_shown(""):
            scene = None
            if not self._scene_drawn and self._task is not None and self._task.project is not None:
                scene = scene_of(self._task.project)
            overlay_of(design).set_iterate(T, q, scene)
        self._scene_drawn = True
        self._rest_until = time.perf_counter() + 2 * (time.perf_counter() - start)

    def _ended(self, outcome: Outcome) -> None:
        task, design = self._task, self._design()
        self._task = None
        if design is None or task is None:
            self._tell(False)
            return
        with errors_shown(task.title):
            self._settle(design, task, outcome)
        if outcome.value is not None:
            self._drawing = True  # in a turn of the event loop of its own: each holds the window for a while
            QtCore.QTimer.singleShot(0, lambda: self._show(task))
            return
        self._tell(False)

    def _settle(self, design: Any, task: Task, outcome: Outcome) -> None:
        set_running(design, False)
        if outcome.value is not None:
            task.finish(design, outcome.value)
            return
        if outcome.error is not None:
            show_error(outcome.error, task.title)
        else:
            show_line(translate("CurveUps", "{task} was cancelled: the design is as it was", task=task.title))
        overlay_of(design).show_design()

    def _show(self, task: Task) -> None:
        """Draws what a run has made, tells of its end, and brings first tiles or a first layout into view."""
        self._drawing, design = False, self._design()
        if design is not None:
            with errors_shown(task.title):
                if task.follow is not None:
                    task.follow(design)
                overlay_of(design).show_design()
        self._tell(False)
        if design is None:  # it went away meanwhile
            return
        if task.told is not None:
            with errors_shown(task.title):
                task.told()
        view = active_view(design.Document.Name)
        if view is not None and self._before != (has_tiles(design), has_layout(design)):
            view.fitAll()

    def _design(self) -> Any:
        document, name = self._place
        known = FreeCAD.listDocuments().get(document)
        return known.getObject(name) if known else None

    def _tell(self, goes_on: bool) -> None:
        status = WORKER.status()
        self._told = status.stage, time.perf_counter()
        what = words_of(status.what) if status.what else translate("CurveUpsSolve", label_of(status.stage))
        status = replace(status, what=what)
        if not goes_on:
            FreeCADGui.getMainWindow().statusBar().clearMessage()
        elif not self._observers:  # no panel shows it
            FreeCADGui.getMainWindow().statusBar().showMessage(f"CurveUps: {status.what}")
        for observer in list(self._observers):
            observer(status, goes_on)


LIVE = Live()
