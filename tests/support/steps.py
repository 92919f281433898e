# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests in the window begin with and wait for. This module is imported inside of FreeCAD alone."""

import FreeCAD
import FreeCADGui
from curveups.window.commands.new_design import make_design
from curveups.window.panels import panel as panels
from curveups.window.run import LIVE
from robot import QtGui, fill, settle, tidy


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


def panel():
    """The panel that is open."""
    return panels.current()


def enter(form, name, text):
    """Types a parameter, which may have to be scrolled to."""
    fill(form.findChild(QtGui.QAbstractSpinBox, name), text)


def in_units(number):
    """The window shows the unit schema of that number."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", number)
    FreeCAD.Units.setSchema(number)


__all__ = ["LIVE", "begin", "enter", "example", "in_units", "opened", "panel"]
