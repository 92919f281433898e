# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of a design from the window (Check, Solve, Verify, Repair, Build Solids, and the tiles for Cuts), and
the lines that macros record of them."""

from __future__ import annotations

from functools import partial
from typing import Any, Callable, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError
from ..base.native import problem
from ..features import actions
from ..features.document import has_layout
from .qt import translate
from .run import LIVE, Task


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


def start(which: str, design: Any, told: Optional[Callable[[], None]] = None) -> None:
    """Start a run on the worker. When it ends, the document takes its results, and `told` is called. Raises
    CurveUpsError where it can't start."""
    wrong = reason(which, design)
    if wrong:
        raise CurveUpsError(wrong)
    command = "".join(word.capitalize() for word in which.split("_"))
    title = translate(f"CurveUps_{command}", actions.RUNS[which].title)
    project, work = actions.prepare(which, design)
    LIVE.start(design, Task(title, work, partial(finish, which), project, told))


def finish(which: str, design: Any, value: Any, *arguments: str) -> None:
    """Hand the value of a thread's work to the function `which` of `actions`, and call that as a macro does.
    arguments: as Python text."""
    actions.hand_over(which, design, value)
    call(f"actions.{which}", named(design), *arguments)
