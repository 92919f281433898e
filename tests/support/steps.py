# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests in the window begin with and wait for. This module is imported inside of FreeCAD alone."""

import atexit
import os
import re
import threading

import FreeCAD
import FreeCADGui
import numpy as np
from curveups.window.commands.new_design import make_design
from curveups.window.panels import panel as panels
from curveups.window.overlays import overlay_of
from curveups.window.run import LIVE
from robot import (QtGui, at_rest, click, close_panel, display, fill, in_dialog, on_screen, settle, tidy,
                   window)

# Words that no German text has, but names of files may.
ENGLISH = re.compile(r"(?<![\w-])(the|tiles|are|back|front|face|lower|with|room|margin|checking|writing|of"
                     r"|to)(?!\w|-|\.\w)")


def begin():
    """A new document in a tidy window."""
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    settle(300)
    tidy()
    made = FreeCAD.newDocument("Made")
    made.UndoMode = 1
    settle(200)
    return made


def example(name="half-sphere", **values):
    """Its document, and a design that is small enough to be solved while one waits."""
    made = begin()
    design = make_design(made, repr(name))
    for key, value in values.items():
        setattr(design, key, value)
    made.recompute()
    return made, design


def opened(path):
    """The document of a file and its design, in a tidy window."""
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    tidy()
    document = FreeCAD.openDocument(str(path))
    document.UndoMode = 1
    settle(500)
    return document, document.Design


def quit_freecad(left, look=lambda: None):
    """By its own window, whose document has changed, while something is at work: `look` at it while FreeCAD
    asks. The file `left` says how FreeCAD ended: status, whether anything was at work, any thread of ours."""
    ended: list[int] = []
    setattr(os, "_exit", ended.append)  # it is FreeCAD itself that ends here

    def leave():
        names = [thread.name for thread in threading.enumerate()]
        with open(left, "w") as file:
            file.write(f"{ended} {LIVE.busy} {'CurveUps' in names}")

    atexit.register(leave)

    def discard():
        assert LIVE.busy
        look()
        box = QtGui.QApplication.activeModalWidget()
        click(next(button for button in box.findChildren(QtGui.QPushButton)
                   if "iscard" in button.text() or "without" in button.text().lower()))

    in_dialog(window.close, discard)


def panel():
    """The panel that is open."""
    return panels.current()


def leave():
    """Closes whatever a command has opened, once it is at rest."""
    at_rest()
    if panel() is not None:
        panel().reject()
    elif FreeCADGui.Control.activeDialog():
        close_panel()
    settle(200)


def enter(form, name, text):
    """Types a parameter, which may have to be scrolled to."""
    fill(form.findChild(QtGui.QAbstractSpinBox, name), text)


def in_units(number):
    """The window shows the unit schema of that number."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", number)
    FreeCAD.Units.setSchema(number)


def edge_at(design, x, y):
    """The interior edge between two tiles whose middle is nearest to a place, from above, on the front."""
    overlay = overlay_of(design)
    corners, shift = overlay.figures()[0]
    F = overlay.scene.F
    seen: dict[tuple[int, ...], list] = {}
    for tile in range(len(F)):
        for k in range(3):
            pair = tuple(sorted((int(F[tile][k]), int(F[tile][(k + 1) % 3]))))
            seen.setdefault(pair, []).append((corners[tile, k] + corners[tile, (k + 1) % 3]) / 2)
    inner = {pair: places for pair, places in seen.items() if len(places) == 2}
    return min(inner.items(), key=lambda one: np.hypot(*(one[1][0][:2] - (x, y))))


def point_in(design, pair):
    """A little inside one of its tiles, so that the pixel is on it."""
    overlay = overlay_of(design)
    corners, shift = overlay.figures()[0]
    tile = next(t for t, face in enumerate(overlay.scene.F.tolist()) if set(pair) <= set(face))
    own = corners[tile, :3]
    face = overlay.scene.F[tile].tolist()
    ends = own[[k for k in range(3) if face[k] in pair]]
    return FreeCAD.Vector(*map(float, 0.9 * ends.mean(0) + 0.1 * own.mean(0)))


def move_to(design, pair):
    point = on_screen(point_in(design, pair))
    display("mousemove", point.x() - 3, point.y())
    display("mousemove", point.x(), point.y())
    settle(250)


def click_edge(design, x, y):
    pair, places = edge_at(design, x, y)
    move_to(design, pair)
    display("click", 1)
    settle(400)
    return pair


__all__ = ["ENGLISH", "LIVE", "begin", "click_edge", "edge_at", "enter", "example", "in_units", "move_to",
           "opened", "panel", "point_in"]
