# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work of the window, on one worker: the run that a command starts, and the solids that follow edits; and the
lines that macros record of it. Settled forces follow a run like solids.

A timer draws a run as it goes, and hands its results over when it ends. Panels come and go meanwhile; so may
the document, and FreeCAD itself. Solids are built after the transaction and outside of it: an undo holds
numbers alone, nobody waits, and what is not up to date yet says so. An edit, or a run, ends what is being
built.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Callable, Iterable, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError
from ..base.findings import refused
from ..base.native import problem
from ..features import actions, proxy
from ..features.design import (SOLIDS, bodies_record, design_project_of, fail_solids, lacks_solids,
                               take_solids)
from ..features.document import has_layout, set_running, take_settled
from ..features.status import awaits_settling, has_tiles
from ..project.keys import Record
from ..project.project import Project
from ..project.worker import WORKER, Outcome, Status
from ..stages import SETTLED, label_of
from ..stages.stage import Job
from .notice import errors_shown, show_error, show_line, words_of
from .overlay.scene import scene_of
from .overlay.showing import active_view
from .overlays import Place, overlay_of, place_of
from .preferences import draws_live
from .qt import QtCore, QtWidgets, translate

INTERVAL = 40  # ms between looks at the worker
REPORTS = 0.2  # s between reports of how far a stage is: each has the whole window composed anew
PAUSE = 250  # ms without another edit, before solids are built
QUIT_SECONDS = 20.0  # that FreeCAD waits for a native call to see that it is stopped


@dataclass(frozen=True)
class Task:
    """title: of the command. work: for the worker's thread; it touches no document. finish: takes the value
    of the work, in the window's thread; a recompute follows. project: of the work, for pictures of it. told:
    called once the results are drawn."""

    title: str
    work: Callable[[Job], Any]
    finish: Callable[[Any, Any], None]  # design, value
    project: Optional[Project] = None
    told: Optional[Callable[[], None]] = None


Observer = Callable[[Status, bool], None]  # where the run is; whether it goes on


class Live:
    """Starts tasks and tells observers. One at a time: the second is refused with a CurveUpsError. A document
    observer."""

    def __init__(self) -> None:
        self._observers: list[Observer] = []
        self._timer: Any = None
        self._pause: Any = None
        self._task: Optional[Task] = None
        self._place: Place = ("", "")  # design of the run
        self._drawn, self._rest_until = 0, 0.0  # number of the iterate in the view; time of the next one
        self._reported = ("", 0.0)  # stage of the last report, and when
        self._before = False, False  # whether the design had tiles, and a layout
        self._to_build: dict[Place, None] = {}  # designs whose solids are to be built
        self._to_settle: dict[Place, Project] = {}  # projects of runs whose settled forces follow
        self._building: Optional[Place] = None
        self._silent = False  # nobody has to know that the run was cancelled

    @property
    def busy(self) -> bool:
        return self._task is not None

    @property
    def waiting(self) -> bool:
        """True while settled forces are to follow."""
        return bool(self._to_settle)

    def obstacle(self) -> str:
        """Reason why nothing else can begin now; empty where it can."""
        return translate("CurveUps", "CurveUps is at work: stop or cancel that first") if self.busy else ""

    def runs_on(self, design: Any) -> bool:
        """True while the run is this design's."""
        return self.busy and self._place == place_of(design)

    def observe(self, observer: Observer) -> None:
        self._observers.append(observer)

    def forget(self, observer: Observer) -> None:
        if observer in self._observers:
            self._observers.remove(observer)

    def start(self, design: Any, task: Task) -> None:
        """Start a run. Raises CurveUpsError where there is one already."""
        if self.busy:
            raise CurveUpsError(self.obstacle())
        self._end_building()
        WORKER.start_work(task.work, self._ended)
        self._task, self._place, self._silent = task, place_of(design), False
        self._drawn, self._rest_until = 0, 0.0
        self._before = has_tiles(design), has_layout(design)
        set_running(design, True)
        self._timer.start()
        self._report(True)

    def stop(self) -> None:
        """Keep the best so far."""
        if self._task is not None:
            WORKER.stop()
            self._report(True)

    def cancel(self, silent: bool = False) -> None:
        """Leave the design as it was. silent: do not say so."""
        if self._task is not None:
            self._silent = silent
            WORKER.cancel()
            WORKER.poll()

    def withdraw(self, tasks: Iterable[Task], silent: bool = True) -> None:
        """Cancel the run if it is one of these tasks."""
        if any(task is self._task for task in tasks):
            self.cancel(silent)

    def quit(self) -> None:
        """FreeCAD ends: no thread may be left in the native module."""
        self._place, self._building = ("", ""), None
        self._timer.stop()
        self._pause.stop()
        WORKER.cancel()
        WORKER.wait(QUIT_SECONDS)

    def install(self) -> None:
        """Prepare timers, and observe documents; once for each window."""
        if self._timer is not None:
            return
        self._timer, self._pause = QtCore.QTimer(), QtCore.QTimer()
        self._timer.setInterval(INTERVAL)
        self._timer.timeout.connect(lambda: self._look())
        self._pause.setInterval(PAUSE)
        self._pause.setSingleShot(True)
        self._pause.timeout.connect(lambda: self._build())
        FreeCAD.addDocumentObserver(self)
        QtWidgets.QApplication.instance().aboutToQuit.connect(lambda: self.quit())
        proxy.build_later = self.build_later

    # Documents.

    def slotDeletedDocument(self, document: Any) -> None:
        self._abandon(document.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        self._abandon(obj.Document.Name, obj.Name)

    def slotCommitTransaction(self, document: Any) -> None:
        """Go on with what waited for the end of a transaction."""
        if self._to_build or self._to_settle:
            self._pause.start()

    slotAbortTransaction = slotCommitTransaction

    def _abandon(self, document: str, name: str = "") -> None:
        """Touch nothing any more of a design, or a document, that is going away."""
        def goes(place: Optional[Place]) -> bool:
            return place is not None and place[0] == document and name in ("", place[1])

        self._to_build = {place: None for place in self._to_build if not goes(place)}
        self._to_settle = {place: kept for place, kept in self._to_settle.items() if not goes(place)}
        if goes(self._building):
            self._end_building()
        if self.busy and goes(self._place):
            self._place = ("", "")
            self.cancel()

    # Runs.

    def _look(self) -> None:
        WORKER.poll()
        if WORKER.idle:
            self._timer.stop()
        if not WORKER.busy:
            return
        status, (stage, when) = WORKER.status(), self._reported
        if self._building is not None:
            if status.seconds > 1 and time.perf_counter() >= when + REPORTS:
                self._reported = "", time.perf_counter()
                _show_in_bar(translate(
                    "CurveUps", "CurveUps: building solids ({seconds:.0f} s); an edit ends it",
                    seconds=status.seconds) if status.stage != SETTLED else translate(
                    "CurveUps", "CurveUps: settling tiles ({seconds:.0f} s); an edit ends it",
                    seconds=status.seconds))
            return
        if status.stage != stage or time.perf_counter() >= when + REPORTS:
            self._report(True)
        self._draw(status)

    def _draw(self, status: Status) -> None:
        """Draw the newest iterate; pictures that take long come more seldom."""
        design = _find(self._place)
        if (design is None or status.iterate is None or status.count == self._drawn or status.stopping
                or not draws_live() or time.perf_counter() < self._rest_until):
            return
        start, first, project = time.perf_counter(), not self._drawn, self._task and self._task.project
        self._drawn = status.count
        with errors_shown(""):
            scene = scene_of(project) if first and project else None
            overlay_of(design).set_iterate(*status.iterate, scene)
        self._rest_until = time.perf_counter() + 2 * (time.perf_counter() - start)

    def _ended(self, outcome: Outcome) -> None:
        """Store and draw the results of the run, tell of its end, and bring first tiles or a first layout
        into view."""
        task, design = self._task, _find(self._place)
        self._task = None
        if design is None or task is None:
            self._report(False)
            return
        with errors_shown(task.title):
            set_running(design, False)
            if outcome.value is not None:
                task.finish(design, outcome.value)
                design.Document.recompute()
                if task.project is not None:
                    self._to_settle[place_of(design)] = task.project
            elif outcome.error is not None:
                show_error(outcome.error, task.title)
            elif not self._silent:
                show_line(translate("CurveUps", "{task} was cancelled: the design is as it was",
                                    task=task.title))
        with errors_shown(task.title):
            overlay_of(design).show_design()
        self._report(False)
        if outcome.value is None:
            return
        if task.told is not None:
            with errors_shown(task.title):
                task.told()
        view = active_view(design.Document.Name)
        if view is not None and self._before != (has_tiles(design), has_layout(design)):
            view.fitAll()

    def _report(self, goes_on: bool) -> None:
        status = WORKER.status()
        self._reported = status.stage, time.perf_counter()
        what = words_of(status.what) if status.what else translate("CurveUpsSolve", label_of(status.stage))
        status = replace(status, what=what)
        if not goes_on:
            _show_in_bar("")
            self._pause.start()  # solids that waited for the end
        elif not self._observers:  # no panel shows it
            _show_in_bar(f"CurveUps: {status.what}")
        for observer in list(self._observers):
            observer(status, goes_on)

    # Solids.

    def build_later(self, design: Any, to_build: bool) -> None:
        """Build the solids of a design that was edited, once nothing else is at work; or not any more."""
        place = place_of(design)
        if self._building == place:
            self._end_building()
        self._to_build.pop(place, None)
        if to_build:
            self._to_build[place] = None
            self._pause.start()

    def _build(self) -> None:
        """Start with the first design that needs solids, else settled forces, outside of transactions."""
        if self.busy or self._building is not None or problem() is not None:
            return
        for place in list(self._to_build):
            design = _find(place)
            if design is not None and design.Document.HasPendingTransaction:
                continue
            del self._to_build[place]
            if design is None or not lacks_solids(design):
                continue
            record = bodies_record(design)
            try:
                project = design_project_of(design)
            except CurveUpsError as error:
                fail_solids(design, refused(error), record)
                continue
            WORKER.start(project, SOLIDS, partial(self._built, design, record))
            self._building = place
            self._timer.start()
            return
        for place, project in list(self._to_settle.items()):
            design = _find(place)
            if design is not None and design.Document.HasPendingTransaction:
                continue
            if design is None or not awaits_settling(design):
                del self._to_settle[place]
                continue
            WORKER.start(project, (SETTLED,), partial(self._settled, design))
            self._building = place
            self._timer.start()
            return

    def _built(self, design: Any, record: Record, outcome: Outcome) -> None:
        place, self._building = self._building, None
        _show_in_bar("")
        self._pause.start()  # the next one
        if place is None or outcome.cancelled:
            return
        error = outcome.error
        if error is not None and not isinstance(error, CurveUpsError):
            error = CurveUpsError(f"unexpected failure: {error}", design.Label, "please report it")
        if design.Document.HasPendingTransaction:  # which would hold the shapes
            self._to_build[place] = None
        elif error is not None:
            fail_solids(design, refused(error), record)
        elif outcome.value is not None:
            take_solids(design, outcome.value)

    def _settled(self, design: Any, outcome: Outcome) -> None:
        place, self._building = self._building, None
        _show_in_bar("")
        self._pause.start()  # the next one
        if place is None or outcome.cancelled or design.Document.HasPendingTransaction:
            return
        self._to_settle.pop(place, None)
        with errors_shown(translate("CurveUps_Verify", "Verify")):
            if outcome.error is not None:
                raise outcome.error
            take_settled(design, outcome.value)

    def _end_building(self) -> None:
        """Drop solids or settled forces that are being made; they are made again later."""
        if self._building is not None:
            self._to_build[self._building] = None
            WORKER.cancel()
            WORKER.poll()


def _find(place: Place) -> Any:
    document = FreeCAD.listDocuments().get(place[0])
    return document.getObject(place[1]) if document else None


def _show_in_bar(text: str) -> None:
    bar = FreeCADGui.getMainWindow().statusBar()
    if text:
        bar.showMessage(text)
    elif bar.currentMessage().startswith("CurveUps: "):  # no other message has taken its place
        bar.clearMessage()


LIVE = Live()


def call(function: str, *arguments: str) -> None:
    """Call a function of curveups.features with arguments as Python text, and record it: the line in the
    macro does the same in a FreeCAD without a window. function: "document.new_design", say. Raises the errors
    of the function."""
    FreeCADGui.doCommand(f"from curveups.features import {function.split('.')[0]}")
    FreeCADGui.doCommand(f"{function}({', '.join(arguments)})")


def assign(obj: Any, name: str, value: Any) -> None:
    """Set a property of an object, and record it; numbers are in FreeCAD's own units."""
    FreeCADGui.doCommand(f"{named(obj)}.{name} = {value!r}")


def new_document(name: str, label: str) -> Any:
    """Make a new document, which becomes the active one, and record it."""
    FreeCADGui.doCommand(f"FreeCAD.newDocument({name!r}, {label!r})")
    return FreeCAD.ActiveDocument


def named(obj: Any) -> str:
    """Python text of a document object."""
    return f"FreeCAD.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


def reason(which: str, design: Any) -> str:
    """Reason why a run of a design can't start now; empty where it can."""
    wrong = problem()
    if wrong is not None:
        return str(wrong)
    if LIVE.busy:
        return LIVE.obstacle()
    of_target = which in actions.RUNS and actions.RUNS[which].of_target  # exports are of a layout
    if not of_target and not has_layout(design):
        return translate("CurveUps", "There is no layout yet: Solve makes it")
    return ""


def start(which: str, design: Any, told: Optional[Callable[[], None]] = None) -> Task:
    """Start a run on the worker. When it ends, the document takes its results, and `told` is called. Raises
    CurveUpsError where it can't start."""
    wrong = reason(which, design)
    if wrong:
        raise CurveUpsError(wrong)
    command = "".join(word.capitalize() for word in which.split("_"))
    title = translate(f"CurveUps_{command}", actions.RUNS[which].title)
    project, work = actions.prepare(which, design, settles=False)  # settled forces follow by themselves
    task = Task(title, work, partial(finish, which), project, told)
    LIVE.start(design, task)
    return task


def finish(which: str, design: Any, value: Any, *arguments: str) -> None:
    """Hand the value of a thread's work to the function `which` of `actions`, and call that as a macro does.
    arguments: as Python text."""
    actions.hand_over(which, design, value)
    call(f"actions.{which}", named(design), *arguments)
