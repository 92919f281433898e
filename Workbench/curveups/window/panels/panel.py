# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of all panels: one is open at a time, and the next takes its place. A panel follows its design's
overlay and goes with the design."""

from __future__ import annotations

from abc import ABC, abstractmethod
from contextlib import suppress
from typing import Any, Callable, Optional

import FreeCADGui

from ...base.errors import CurveUpsError
from ...project.worker import WORKER, Status
from ..notice import follow_link, show_in
from ..overlays import overlay_of
from ..qt import QtCore, QtWidgets, load_ui, translate
from ..run import LIVE

_current: Optional["Panel"] = None


def current() -> Optional["Panel"]:
    """The panel that is open, if one of ours is."""
    return _current if _current is not None and _current.form is not None else None


def obstacle() -> str:
    """Why no panel of ours can be opened: a task panel of another workbench is open. Empty where one can."""
    if FreeCADGui.Control.activeDialog() and current() is None:
        return translate("CurveUps", "Another task panel is open: close it first")
    return ""


def show(kind: Any, design: Any) -> Any:
    """Opens the panel of this kind (its class) for a design in the place of ours that is open; the open one
    where it is that already. Raises CurveUpsError where a task panel of another workbench is open."""
    global _current
    if current() is not None and type(_current) is kind and _current.place == _place(design):
        return _current
    if obstacle():
        raise CurveUpsError(obstacle())
    if _current is not None:
        _current.reject()
    _current = kind(design)
    FreeCADGui.Control.showDialog(_current)
    return _current


def _place(design: Any) -> tuple[str, str]:
    return design.Document.Name, design.Name


def enable(button: Any, reason: str = "") -> None:
    """A button, or grey with the reason why it has nothing to do in its tooltip."""
    tip = button.property("CurveUpsTip")
    if tip is None:
        tip = button.toolTip()
        button.setProperty("CurveUpsTip", tip)
    button.setEnabled(not reason)
    button.setToolTip(f"{tip}<br><i>{reason}</i>" if reason else tip)
    button.setStatusTip(reason)


def fill_fields(box: Any, names: list[str]) -> None:
    """Fields of an overlay by name, into a box that may have them already."""
    if names != [box.itemData(k) for k in range(box.count())]:
        box.clear()
        for name in names:
            box.addItem(translate("CurveUps_Fields", name), name)


def fit_columns(tree: Any) -> None:
    """The first column takes what its others leave."""
    header = tree.header()
    header.setStretchLastSection(False)
    header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
    header.setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)


class Panel(ABC):
    """FreeCAD's task dialog for a design: `form` is its widget, and None once FreeCAD has closed it without
    asking. Where the form has a `line`, messages come there, the panel is told how runs go, and shows how far
    they are in the form's `progress`; its `stop` and `cancel` end this design's run."""

    form: Any

    def __init__(self, design: Any, ui: str, title: str):
        """ui: the file in resources/ui."""
        self.design, self.place = design, _place(design)
        self.form = load_ui(ui)
        if QtWidgets.QApplication.instance().styleSheet():  # dark themes give buttons much empty room
            self.form.setStyleSheet("QPushButton { padding-left: 3px; padding-right: 3px; }")
        # FreeCAD makes the panel as wide as its title.
        letters = self.form.fontMetrics()
        self.form.setWindowTitle(letters.elidedText(title, QtCore.Qt.ElideRight, 9 * letters.height()))
        self._overlay = overlay_of(design)
        self._hidden: Any = None  # the surface, while it would cover its target
        self._line: Any = getattr(self.form, "line", None)
        for name in ("line", "verdict", "doubts"):
            if hasattr(self.form, name):
                getattr(self.form, name).linkActivated.connect(lambda link: follow_link(link))
        ends: dict[str, Callable[[], object]] = {"stop": LIVE.stop, "cancel": LIVE.cancel}
        self._on_clicks(**{name: end for name, end in ends.items() if hasattr(self.form, name)})
        # Once for many changes.
        self._later = QtCore.QTimer(self.form)
        self._later.setSingleShot(True)
        self._later.timeout.connect(lambda: self.show())

    def _on_clicks(self, **actions: Callable[[], object]) -> None:
        """What buttons of the form do, by their names."""
        for name, action in actions.items():
            getattr(self.form, name).clicked.connect(lambda *_, action=action: action())

    def _follow(self) -> None:
        """To be called once the form is ready."""
        self._overlay.observers.append(self._changed)
        if self._overlay.scene is None:  # of a design that is hidden
            self._overlay.refresh()
        if self._line is not None:
            self._say("")
            show_in(self._say)
            LIVE.observe(self._run_changed)
            running = LIVE.runs_on(self.design)
            self._show_progress(WORKER.status(), running)
            self._show_running(running)
        self.show()

    def _uncover(self) -> None:
        """Hides the surface of the target until the panel closes."""
        source = getattr(self.design.Target, "Source", None)
        if self._hidden is None and source is not None and source.Visibility:
            self._hidden, source.Visibility = source, False

    @abstractmethod
    def show(self) -> None:
        """Takes over what has changed of the design or the overlay."""

    def _show_run(self, status: Status, goes_on: bool) -> None:
        """How the run of the window stands, whatever design it is for."""
        self._show_running(goes_on and LIVE.runs_on(self.design))

    def _show_running(self, running: bool) -> None:
        """What can be done while this design's run goes on, and after it."""

    def _show_progress(self, status: Status, running: bool) -> None:
        """How far this design's run is, and what it does, where the form has a place for that; and whether
        there is something to end."""
        for name in ("stop", "cancel"):
            if hasattr(self.form, name):
                enable(getattr(self.form, name),
                       "" if running else translate("CurveUps", "Nothing is at work"))
        bar = getattr(self.form, "progress", None)
        if bar is None:
            return
        # Empty where nobody knows how far it is. Without a maximum, styles animate it, and go on when it has
        # one again: FreeCAD has the whole window composed anew for each picture.
        bar.setValue(int(100 * min(max(status.fraction, 0.0), 1.0)) if running else 0)
        bar.setTextVisible(running and status.fraction >= 0)
        if hasattr(self.form, "doing"):
            what = translate("CurveUpsSolve", "stopping") if status.stopping else status.what
            self.form.doing.setText(f"{what}, {status.seconds:.0f} s" if running else "")

    def _say(self, text: str) -> None:
        """A line of rich text at the top."""
        if self.form is not None:
            self._line.setText(text)
            self._line.setVisible(bool(text))

    def _run_changed(self, status: Status, goes_on: bool) -> None:
        if self.form is None:
            self.close()
        else:
            self._show_progress(status, goes_on and LIVE.runs_on(self.design))
            self._show_run(status, goes_on)

    def _changed(self) -> None:
        try:
            if self._overlay.closed:
                self.reject()  # at once: FreeCAD may be ending
            else:
                self._later.start(0)
        except RuntimeError:  # the form went with its window
            self.close()

    def close(self) -> None:
        """Lets go of all that calls the panel; its widgets may be gone at any time after."""
        global _current
        if self._changed in self._overlay.observers:
            self._overlay.observers.remove(self._changed)
        if self._line is not None:
            LIVE.forget(self._run_changed)
            show_in(None)
        if self._hidden is not None:
            with suppress(ReferenceError):  # it was deleted meanwhile
                self._hidden.Visibility = True
            self._hidden = None
        if _current is self:
            _current = None

    def reject(self) -> bool:
        """The close button, the escape key, and the next panel."""
        asked = self.form is not None
        self.close()
        if asked:
            FreeCADGui.Control.closeDialog()
        return True

    def getStandardButtons(self) -> int:
        close = QtWidgets.QDialogButtonBox.Close
        return int(getattr(close, "value", close))  # an enumeration's member in PySide6

    def isAllowedAlterDocument(self) -> bool:
        """Nothing here holds the document: commands stay active."""
        return True

    isAllowedAlterView = isAllowedAlterSelection = isAllowedAlterDocument
