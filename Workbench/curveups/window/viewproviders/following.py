# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids follow edits in a window: after the transaction, outside of it, on a thread of their own.

An undo then holds numbers alone, nobody waits, and what is not up to date yet says so. Another edit ends
what is being built for the one before.
"""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import FreeCADGui

from ...base.errors import CurveUpsError
from ...base.findings import refused
from ...base.native import problem
from ...features import live, properties, rebuild
from ...features.proxy import designs
from ...features.status import read_keys
from ...project.worker import Outcome, Worker
from ..qt import QtCore, translate

PAUSE = 250  # ms without another edit, before solids are built
POLL = 40  # ms


class Follower:
    """A document observer that builds what is out of date, one design after another."""

    def __init__(self) -> None:
        self._worker = Worker()
        self._design: Optional[Any] = None   # whose solids are being built
        self._values: dict[str, Any] = {}    # for what it is built
        self._told = ""  # what the status bar was given to say of it
        self._wait, self._poll = QtCore.QTimer(), QtCore.QTimer()
        self._wait.setSingleShot(True)
        self._wait.setInterval(PAUSE)
        self._wait.timeout.connect(lambda: self.follow())
        self._poll.setInterval(POLL)
        self._poll.timeout.connect(lambda: self._look())
        QtCore.QCoreApplication.instance().aboutToQuit.connect(lambda: self.cancel(wait=True))

    def later(self, *_: Any) -> None:
        """Looks what is out of date once there is peace."""
        self._wait.start()

    slotCommitTransaction = slotUndoDocument = slotRedoDocument = slotAbortTransaction = later
    slotRecomputedDocument = later

    def slotDeletedDocument(self, document: Any) -> None:
        if self._design is not None and self._design.Document == document:
            self.cancel()

    def slotDeletedObject(self, obj: Any) -> None:
        if obj == self._design:
            self.cancel()

    def cancel(self, wait: bool = False) -> None:
        """Drops what is being built."""
        self._worker.cancel()
        self._look()
        if wait:
            self._wait.stop()
            self._worker.wait()

    def follow(self) -> None:
        """Builds for the first design that needs it."""
        if problem() is not None:
            return
        for document in FreeCAD.listDocuments().values():
            wanted = next(filter(_wanted, designs(document)), None)
            if wanted is None:
                continue
            if not document.HasPendingTransaction:
                self._build(wanted)
                return
            self.later()

    def _build(self, design: Any) -> None:
        values = _values(design)
        if self._worker.busy:
            if design == self._design and values == self._values:
                return
            self.cancel()
        try:
            project = live.design_project_of(design)
            self._worker.start(project, rebuild.GOALS, self._take)
        except CurveUpsError as error:
            rebuild.fail(design, refused(error))
            return
        self._design, self._values = design, values
        self._poll.start()

    def _take(self, outcome: Outcome) -> None:
        design, values, self._design = self._design, self._values, None
        if design is None or outcome.cancelled:
            return
        error = outcome.error
        if error is not None and not isinstance(error, CurveUpsError):
            error = CurveUpsError(f"unexpected failure: {error}", design.Label, "please report it")
        # Shapes would be copied into a transaction.
        if design.Document.HasPendingTransaction or _values(design) != values:
            self.later()
        elif error is not None:
            rebuild.fail(design, refused(error))
        elif outcome.value is not None:
            rebuild.take(design, outcome.value)
            self.later()

    def _look(self) -> None:
        self._worker.poll()
        if self._worker.idle:
            self._poll.stop()
        if not self._worker.busy:
            bar = FreeCADGui.getMainWindow().statusBar()
            if self._told and bar.currentMessage() == self._told:  # no other message has taken its place
                bar.clearMessage()
            self._told = ""
            return
        now = self._worker.status()
        if now.seconds > 1:
            self._told = translate("CurveUps", "CurveUps: building solids ({seconds:.0f} s); an edit ends it",
                                   seconds=now.seconds)
            FreeCADGui.getMainWindow().statusBar().showMessage(self._told)


def _wanted(design: Any) -> bool:
    proxy = getattr(design, "Proxy", None)
    return (proxy is not None and proxy.ready and not proxy.running and not proxy.refused(design)
            and rebuild.needed(design) and not rebuild.failed(design))


def _values(design: Any) -> dict[str, Any]:
    made = read_keys(design).records.get("design")
    return {"design": made and made.content, **properties.values_of(design)}


FOLLOWER: Optional[Follower] = None


def install() -> None:
    """Once for each window."""
    global FOLLOWER
    if FOLLOWER is None:
        FOLLOWER = Follower()
        FreeCAD.addDocumentObserver(FOLLOWER)
