# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Actuate: computes the path from flat to shape, and plays it in the view."""

from __future__ import annotations

from typing import Any, Optional

from ...base.native import translated
from ...features import actions
from ...features.live import stored
from ...features.status import OUT_OF_DATE
from ...stages import RISEN
from ...stages.actuation import Actuation
from .. import runs
from ..notice import errors_shown, show_line, shown
from ..overlay.cameras import active_view
from ..overlay.scene import path_scene_of
from ..overlay.showing import uncover
from ..qt import QtCore, QtWidgets, translate
from ..run import LIVE, Task
from ..units import text_of
from .panel import Panel, enable

_FRAME = 80  # ms between two pictures


class ActuatePanel(Panel):
    """The view shows the path while the panel is open, and the design as it is after an edit."""

    def __init__(self, design: Any):
        super().__init__(design, "actuate",
                         translate("CurveUps_Actuate", "Path of {name}", name=design.Label))
        form = self.form
        self._clock = QtCore.QTimer(form)
        self._clock.timeout.connect(lambda: self._advance())
        form.frame.valueChanged.connect(lambda *_: self._draw())
        form.frame.sliderPressed.connect(lambda: self._play(False))
        self._on_clicks(run=self.run, play=lambda: self._play(not self._clock.isActive()),
                        select=self._select, save=self._save)
        self._take(None)
        self._follow()
        self._draw()

    def close(self) -> None:
        """The view shows the design again."""
        if self.form is not None:
            self._clock.stop()
        super().close()
        if not self._overlay.closed:
            self._overlay.refresh()

    def run(self) -> None:
        """Starts the run; the path is played when it ends."""
        self._say("")
        self._play(False)
        with errors_shown(translate("CurveUps_Actuate", "Actuate")):
            # Later: the view is about to show the design with its results.
            runs.start("actuate", self.design, lambda: QtCore.QTimer.singleShot(0, self._arrived))

    def show(self) -> None:
        """The path that the document holds, and whether it is of the design as it is."""
        found = stored(self.design).latest(RISEN)
        if (found and found.block) != (self._found and self._found.block):
            self._take(found)
        said = found.findings() if found else ()
        self.form.verdict.setText("<br>".join(shown(one) for one in said))
        self.form.note.setVisible(self.design.Actuation.startswith(OUT_OF_DATE))

    def _take(self, found: Optional[Actuation]) -> None:
        form = self.form
        self._found, self._scene = found, None  # type: Optional[Actuation], Any
        if found is not None:
            with translated(self.design.Label):
                self._scene = path_scene_of(found)
        before = form.frame.blockSignals(True)
        form.frame.setRange(0, max(len(found.time) - 1, 0) if found else 0)
        form.frame.setValue(form.frame.maximum())
        form.frame.blockSignals(before)
        form.at.setText("")
        lacks = "" if found else translate("CurveUps_Actuate", "There is no path yet")
        for part in (form.frame, form.play, form.save):
            enable(part, lacks or ("" if found and len(found.time) else translate(
                "CurveUps_Actuate", "The run was stopped before the path")))
        enable(form.select, lacks or ("" if found and found.open_tiles else translate(
            "CurveUps_Actuate", "All contacts close")))

    def _draw(self) -> None:
        """The frame of the slider."""
        found = self._found
        if self.form is None or found is None or not len(found.time) or LIVE.runs_on(self.design):
            return
        number = self.form.frame.value()
        if uncover(self.design):  # and the view is about to show the design
            QtCore.QTimer.singleShot(0, self._draw)
            return
        self._overlay.show_scene(self._scene.posed(found.frame(number)))
        energy = text_of(float(found.energy[number]), "mJ", float(found.energy[0]))
        words = translate("CurveUps_Actuate", "Frame {number} of {count}, {load}: {energy} stored")
        self.form.at.setText(words.format(number=number + 1, count=len(found.time), energy=energy,
                                          load=_words_of(found.loads[number])))

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
        if self._found is not None:
            self._overlay.select_tiles(self._found.open_tiles)

    def _save(self) -> None:
        """Asks for a file, and writes the frame that is shown on the worker."""
        number = self.form.frame.value()
        self._play(False)
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self.form, translate("CurveUps_Actuate", "Tiles as they are shown"),
            f"{actions.file_name(self.design)}-{number + 1}.step", "STEP (*.step *.stp)")
        if not path:
            return
        title = translate("CurveUps_Actuate", "Export STEP")

        def written(design: Any, made: Any) -> None:
            runs.finish("write_frame", design, made, repr(path), str(number))
            show_line(translate("CurveUps_Actuate", "written: {path}", path=path))

        with errors_shown(title):
            work = actions.frame_work(self.design, path, number)
            LIVE.start(self.design, Task(title, work, written, told=lambda: QtCore.QTimer.singleShot(
                0, self._draw)))

    def _arrived(self) -> None:
        """Plays what a run has made, all of it in view."""
        if self.form is None:
            return
        self.show()
        self._play(True)
        self._draw()  # the slider may have been at its beginning
        view = active_view(self.design.Document.Name)
        if view is not None:
            view.fitAll()

    def _show_running(self, running: bool) -> None:
        enable(self.form.run, runs.reason("actuate", self.design))


def _words_of(load: str) -> str:
    """A load case as the panel says it."""
    return {"by_itself": translate("CurveUps_Actuate", "released"),
            "shaken": translate("CurveUps_Actuate", "shaken"),
            "pressed": translate("CurveUps_Actuate", "pressed and let go")}[load]
