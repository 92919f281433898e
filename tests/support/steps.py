# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps that many tests in the window share. Only FreeCAD imports this module."""

import atexit
import os
import re
import threading

import FreeCAD
import FreeCADGui
import numpy as np
from curveups.window import panel as panels
from curveups.window.new_design import make_design
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
    document = FreeCAD.newDocument("Made")
    document.UndoMode = 1
    settle(200)
    return document


def example(name="half-sphere", **values):
    """Document and design of a built-in target that is solved in seconds."""
    document = begin()
    design = make_design(document, repr(name))
    for key, value in values.items():
        setattr(design, key, value)
    document.recompute()
    return document, design


def opened(path):
    """The document of a file and its design, in a tidy window."""
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    tidy()
    document = FreeCAD.openDocument(str(path))
    document.UndoMode = 1
    settle(500)
    return document, document.Design


def quit_freecad(left, look=lambda: None):
    """Close the window, whose document has changed, while a run is at work; `look` at it while FreeCAD asks.
    The file `left` then holds FreeCAD's status, and whether a run and whether a thread of ours was left."""
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
    """Close the panel or dialog of a command, once no run is at work."""
    at_rest()
    if panel() is not None:
        panel().reject()
    elif FreeCADGui.Control.activeDialog():
        close_panel()
    settle(200)


def enter(form, name, text):
    """Type a parameter, after scrolling to it."""
    fill(form.findChild(QtGui.QAbstractSpinBox, name), text)


def in_units(number):
    """Choose the unit schema of that number."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", number)
    FreeCAD.Units.setSchema(number)


def edge_at(design, x, y):
    """The interior edge whose middle is nearest to (x, y) from above, on the front."""
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
    """A point near an edge, a little inside one of its tiles, so that its pixel is on the tile."""
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
