# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls that FreeCAD records for macros."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui


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
