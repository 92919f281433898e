# SPDX-License-Identifier: LGPL-2.1-or-later
"""Actuate: computes the path from flat to shape, and plays it in the view."""

from __future__ import annotations

from typing import Any, Optional

from ..base.native import translated
from ..features.design import stored
from ..features.status import OUT_OF_DATE
from ..stages import RISEN
from ..stages.actuation import Actuation
from . import run
from .binding import silent
from .notice import errors_shown, shown
from .overlay.scene import path_scene_of
from .overlay.showing import active_view, uncover
from .panel import Panel, show
from .qt import QtCore, translate
from .run import LIVE
from .units import text_of

_FRAME = 80  # ms between two pictures


class ActuatePanel(Panel):
    """The path of a design. The view shows it while the panel is open, and the design after an edit."""

    def __init__(self, design: Any):
        super().__init__(design, "actuate")
        form = self.form
        self._clock = QtCore.QTimer(form)
        self._clock.timeout.connect(lambda: self._advance())
        form.frame.valueChanged.connect(lambda *_: self._draw())
        form.frame.sliderPressed.connect(lambda: self._play(False))
        self.on_clicks(run=self.run, play=lambda: self._play(not self._clock.isActive()),
                       select=self._select)
        self.reasons.update(run=lambda: run.reason("actuate", design), frame=self._no_path,
                            play=self._no_path, select=self._no_open_contacts)
        self._take(None)
        self.follow()
        self._draw()

    def end(self) -> None:
        if self.form is not None:
            self._clock.stop()
        if not self._overlay.closed:
            self._overlay.refresh()

    def run(self) -> None:
        """Start the run, and play the path when it ends."""
        self.say("")
        self._play(False)
        with errors_shown(translate("CurveUps_Actuate", "Actuate")):
            # Later: view and panel are about to show the results, and the panel becomes higher.
            run.start("actuate", self.design, lambda: QtCore.QTimer.singleShot(_FRAME, self._arrived))

    def show(self) -> None:
        path = stored(self.design).latest(RISEN)
        if (path and path.block) != (self._path and self._path.block):
            self._take(path)
        findings = path.findings() if path else ()
        self.form.verdict.setText("<br>".join(map(shown, findings)))
        self.form.note.setVisible(self.design.Actuation.startswith(OUT_OF_DATE))

    def _take(self, path: Optional[Actuation]) -> None:
        frame = self.form.frame
        self._path, self._scene = path, None  # type: Optional[Actuation], Any
        if path is not None:
            with translated(self.design.Label):
                self._scene = path_scene_of(path)
        with silent(frame):
            frame.setRange(0, max(len(path.time) - 1, 0) if path else 0)
            frame.setValue(frame.maximum())
        self.form.at.setText("")

    def _no_path(self) -> str:
        if self._path is None:
            return translate("CurveUps_Actuate", "There is no path yet")
        return "" if len(self._path.time) else translate("CurveUps_Actuate",
                                                         "The run was stopped before the path")

    def _no_open_contacts(self) -> str:
        if self._path is None:
            return self._no_path()
        return "" if self._path.open_tiles else translate("CurveUps_Actuate", "All contacts close")

    def _draw(self) -> None:
        """Draw the frame of the slider."""
        path = self._path
        if self.form is None or path is None or not len(path.time) or LIVE.runs_on(self.design):
            return
        number = self.form.frame.value()
        if uncover(self.design):  # and the view is about to show the design
            QtCore.QTimer.singleShot(0, self._draw)
            return
        self._overlay.show_scene(self._scene.posed(path.frame(number)))
        loads = {"by_itself": translate("CurveUps_Actuate", "released"),
                 "shaken": translate("CurveUps_Actuate", "shaken"),
                 "pressed": translate("CurveUps_Actuate", "pressed and let go")}
        self.form.at.setText(translate(
            "CurveUps_Actuate", "Frame {number} of {count}, {load}: {energy} stored", number=number + 1,
            count=len(path.time), load=loads[path.loads[number]],
            energy=text_of(float(path.energy[number]), "mJ", float(path.energy[0]))))

    def _play(self, on: bool) -> None:
        frame = self.form.frame
        if on:
            if frame.value() == frame.maximum():
                frame.setValue(0)
            self._clock.start(_FRAME)
        else:
            self._clock.stop()
        self.form.play.setText(translate("CurveUps_Actuate", "Pause") if on
                               else translate("CurveUps_Actuate", "Play"))

    def _advance(self) -> None:
        frame = self.form.frame
        frame.setValue(frame.value() + 1)
        if frame.value() == frame.maximum():
            self._play(False)

    def _select(self) -> None:
        if self._path is not None:
            self._overlay.select_tiles(self._path.open_tiles)

    def _arrived(self) -> None:
        """Play the path of a run, all of it in view."""
        if self.form is None:
            return
        self.update()
        self._play(True)
        self._draw()  # the slider may have been at its beginning
        view = active_view(self.design.Document.Name)
        if view is not None:
            view.fitAll()


def actuate(design: Any) -> None:
    """Open the panel, and start the run if there is no current path."""
    panel = show(ActuatePanel, design)
    if design.Actuation != "current":
        panel.run()
