# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a design from the window, for Check, Solve, Verify, Repair, Build Solids, and for the
tiles that Cuts needs."""

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
    """Calls a function of curveups.features with arguments as Python text, and records it: the line in the
    macro does the same in a FreeCAD without a window. function: "document.new_design", say. Raises what
    the function raises."""
    FreeCADGui.doCommand(f"from curveups.features import {function.split('.')[0]}")
    FreeCADGui.doCommand(f"{function}({', '.join(arguments)})")


def assign(obj: Any, name: str, value: Any) -> None:
    """Sets a property of an object, and records it; numbers are in FreeCAD's own units."""
    FreeCADGui.doCommand(f"{named(obj)}.{name} = {value!r}")


def new_document(name: str, label: str) -> Any:
    """A new document, which becomes the active one; the macro makes it too."""
    FreeCADGui.doCommand(f"FreeCAD.newDocument({name!r}, {label!r})")
    return FreeCAD.ActiveDocument


def named(obj: Any) -> str:
    """A document object as Python text."""
    return f"FreeCAD.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


def reason(which: str, design: Any) -> str:
    """Why a run of a design can't start now; empty where it can."""
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
    """Starts a run on the worker; its results become the document's when it ends, and `told` is called
    then. Raises CurveUpsError where it can't start."""
    wrong = reason(which, design)
    if wrong:
        raise CurveUpsError(wrong)
    command = "".join(word.capitalize() for word in which.split("_"))
    title = translate(f"CurveUps_{command}", actions.RUNS[which].title)
    project, work = actions.prepare(which, design)
    LIVE.start(design, Task(title, work, partial(finish, which), project, told, _recompute))


def finish(which: str, design: Any, made: Any, *arguments: str) -> None:
    """Hands what a thread has made to the function `which` of `actions`, and calls that as a macro does.
    arguments: as Python text."""
    actions.hand_over(which, design, made)
    call(f"actions.{which}", named(design), *arguments)


def _recompute(design: Any) -> None:
    with design.Proxy.many_changes():
        design.Document.recompute()
    design.Proxy.refresh(design)
