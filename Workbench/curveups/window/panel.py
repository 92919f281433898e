# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of all task panels. One panel is open at a time, and the next takes its place. A panel follows its
design's overlay and closes with the design."""

from __future__ import annotations

from abc import ABC, abstractmethod
from contextlib import suppress
from typing import Any, Callable, Optional, Sequence

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError
from ..project.worker import WORKER, Status
from .notice import follow_link, show_in
from .overlays import overlay_of, place_of
from .qt import QtCore, QtWidgets, load_ui, translate
from .run import LIVE

_current: Optional["Panel"] = None


def current() -> Optional["Panel"]:
    """The open panel of CurveUps."""
    return _current if _current is not None and _current.form is not None else None


def obstacle() -> str:
    """Reason why no panel can open: a task panel of another workbench is open. Empty if one can."""
    if FreeCADGui.Control.activeDialog() and current() is None:
        return translate("CurveUps", "Another task panel is open: close it first")
    return ""


def show(kind: Any, design: Any) -> Any:
    """Open the panel of class `kind` for a design in place of the open one; keep the open one if it is that
    panel. Raises CurveUpsError if a task panel of another workbench is open."""
    global _current
    if current() is not None and type(_current) is kind and _current.place == place_of(design):
        return _current
    if obstacle():
        raise CurveUpsError(obstacle())
    if _current is not None:
        _current.reject()
    _current = kind(design)
    FreeCADGui.Control.showDialog(_current)
    return _current


def enable(widget: Any, reason: str = "") -> None:
    """Enable a widget, or disable it and add the reason to its tooltip."""
    tip = widget.property("CurveUpsTip")
    if tip is None:
        tip = widget.toolTip()
        widget.setProperty("CurveUpsTip", tip)
    widget.setEnabled(not reason)
    widget.setToolTip(f"{tip}<br><i>{reason}</i>" if reason else tip)
    widget.setStatusTip(reason)


def put(label: Any, text: str) -> None:
    """Show a text in a label; hide the label if there is none."""
    label.setText(text)
    label.setVisible(bool(text))


def fit_columns(tree: Any, stretched: Optional[int] = None) -> None:
    """Make columns as wide as their texts; the column `stretched`, by default the last, takes the remaining
    width."""
    header = tree.header()
    header.setStretchLastSection(stretched is None)
    header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
    if stretched is not None:
        header.setSectionResizeMode(stretched, QtWidgets.QHeaderView.Stretch)


def _make_line() -> Any:
    line = QtWidgets.QLabel()
    line.setObjectName("line")
    line.setWordWrap(True)
    line.setTextFormat(QtCore.Qt.RichText)
    line.setTextInteractionFlags(QtCore.Qt.TextBrowserInteraction)
    line.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
    return line


class Panel(ABC):
    """FreeCAD's task dialog for a design. `form` is its widget, and None once FreeCAD has closed it.

    `reasons` says by a part of the form why that has nothing to do now: the part is then disabled. The form's
    `line` at the top shows messages. If the form has them, `progress` and `doing` show how far this design's
    run is, and `stop` and `cancel` end it."""

    form: Any

    def __init__(self, design: Any, ui: str):
        """ui: name of the file in resources/ui."""
        self.design, self.place = design, place_of(design)
        self.form = load_ui(ui)
        if QtWidgets.QApplication.instance().styleSheet():  # dark themes give buttons wide margins
            self.form.setStyleSheet("QPushButton { padding-left: 3px; padding-right: 3px; }")
        # FreeCAD makes the panel as wide as its title.
        title = f"{self.form.windowTitle()}: {design.Label}"
        letters = self.form.fontMetrics()
        self.form.setWindowTitle(letters.elidedText(title, QtCore.Qt.ElideRight, 9 * letters.height()))
        self.reasons: dict[str, Callable[[], str]] = {}
        self._overlay = overlay_of(design)
        self._hidden: Any = None  # the surface, while it would cover its target
        self.form.line = _make_line()
        self.form.layout().insertWidget(0, self.form.line)
        for name in filter(self._has, ("line", "verdict", "doubts")):
            getattr(self.form, name).linkActivated.connect(lambda link: follow_link(link))
        ends: dict[str, Callable[[], object]] = {"stop": LIVE.stop, "cancel": LIVE.cancel}
        for name in filter(self._has, ends):
            self.on_clicks(**{name: ends[name]})
            self.reasons[name] = self._nothing_at_work
        self._later = QtCore.QTimer(self.form)  # one update for many changes
        self._later.setSingleShot(True)
        self._later.timeout.connect(lambda: self.update())

    @abstractmethod
    def show(self) -> None:
        """Show the design and its overlay as they are now."""

    def run_changed(self, status: Status, running: bool) -> None:
        """Show the state of the window's run. running: it is this design's and goes on."""

    def on_clicks(self, **actions: Callable[[], object]) -> None:
        """Connect buttons of the form, by their names, with what they do."""
        for name, action in actions.items():
            getattr(self.form, name).clicked.connect(lambda *_, action=action: action())

    def follow(self) -> None:
        """Follow overlay and runs. To be called once the form is ready."""
        self._overlay.observers.append(self._changed)
        if self._overlay.scene is None:  # a hidden design has no scene yet
            self._overlay.refresh()
        self.say("")
        show_in(self.say)
        LIVE.observe(self._run_changed)
        self._show_run(WORKER.status(), LIVE.busy)
        self.update()

    def update(self) -> None:
        """Show the design, and which parts of the form can be used."""
        self.show()
        self.show_reasons()

    def show_reasons(self) -> None:
        """Enable the parts of the form that can be used now, and disable the others."""
        for name, reason in self.reasons.items():
            enable(getattr(self.form, name), reason())

    def say(self, text: str) -> None:
        """Show a line of rich text at the top."""
        if self.form is not None:
            put(self.form.line, text)

    def go_to(self, tiles: Sequence[int]) -> None:
        """Select tiles, and turn the camera to them."""
        scene = self._overlay.scene
        if tiles and scene is not None and max(tiles) < len(scene.F):
            self._overlay.select_tiles(tiles)
            self._overlay.look_at(tiles)

    def uncover(self) -> None:
        """Hide the surface of the target until the panel closes."""
        source = getattr(self.design.Target, "Source", None)
        if self._hidden is None and source is not None and source.Visibility:
            self._hidden, source.Visibility = source, False

    def end(self) -> None:
        """End what the panel began. Its widgets may be gone: `form` is then None."""

    def close(self) -> None:
        """Disconnect everything that calls the panel. Several of them may do so."""
        global _current
        if self._changed not in self._overlay.observers:
            return
        self._overlay.observers.remove(self._changed)
        LIVE.forget(self._run_changed)
        show_in(None)
        if self._hidden is not None:
            with suppress(ReferenceError):  # it was deleted meanwhile
                self._hidden.Visibility = True
            self._hidden = None
        if _current is self:
            _current = None
        self.end()

    def _has(self, name: str) -> bool:
        return hasattr(self.form, name)

    def _nothing_at_work(self) -> str:
        return "" if LIVE.runs_on(self.design) else translate("CurveUps", "Nothing is at work")

    def _run_changed(self, status: Status, goes_on: bool) -> None:
        if self.form is None:
            self.close()
        elif not self._overlay.closed and self.place[0] in FreeCAD.listDocuments():
            begins = goes_on and not self._goes_on
            self._show_run(status, goes_on)
            if begins:
                self.show_reasons()
            elif not goes_on:
                self.update()

    def _show_run(self, status: Status, goes_on: bool) -> None:
        running = goes_on and LIVE.runs_on(self.design)
        self._goes_on = goes_on
        self.run_changed(status, running)
        if self._has("progress"):
            # Empty where the end is not known. Without a maximum, styles animate a bar, and FreeCAD composes
            # the whole window anew for each picture.
            fraction = min(max(status.fraction, 0.0), 1.0) if running else 0.0
            self.form.progress.setValue(int(100 * fraction))
            self.form.progress.setTextVisible(running and status.fraction >= 0)
            self.form.progress.setVisible(running)
        if self._has("doing"):
            what = translate("CurveUpsSolve", "stopping") if status.stopping else status.what
            put(self.form.doing, f"{what}, {status.seconds:.0f} s" if running else "")

    def _changed(self) -> None:
        try:
            if self._overlay.closed:
                self.reject()  # at once: FreeCAD may be ending
            else:
                self._later.start(0)
        except RuntimeError:  # the form went with its window
            self.close()

    def reject(self) -> bool:
        """Close the panel: its button, the escape key, and the next panel."""
        is_open = self.form is not None
        self.close()
        if is_open:
            FreeCADGui.Control.closeDialog()
        return True

    def getStandardButtons(self) -> int:
        close = QtWidgets.QDialogButtonBox.Close
        return int(getattr(close, "value", close))  # an enumeration's member in PySide6

    def isAllowedAlterDocument(self) -> bool:
        """Keep commands active: no panel holds the document."""
        return True

    isAllowedAlterView = isAllowedAlterSelection = isAllowedAlterDocument
