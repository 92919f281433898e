# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: how FreeCAD sees them, why one can't run, errors, transactions, macros."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Optional

import FreeCAD
import FreeCADGui

from ..features.document import design_of, designs
from ..qt import translate
from .notice import errors_shown


class Command(ABC):
    """One command. Texts are written as QT_TRANSLATE_NOOP(name, text), for FreeCAD to translate; the icon
    is the file of the command's name in resources/icons."""

    name = ""
    text = ""
    tooltip = ""
    shortcut = ""

    @abstractmethod
    def run(self) -> None:
        """The work. Raises CurveUpsError, which the user sees as one line."""

    def reason(self) -> str:
        """Why it can't run now, as a sentence without a full stop; empty where it can. Asked for several
        times a second."""
        return ""

    def menu(self) -> "list[Command]":
        """The commands that this one is a menu of."""
        return []

    def GetResources(self) -> dict[str, Any]:
        return {"Pixmap": self.name, "MenuText": self.text, "ToolTip": self.tooltip,
                "Accel": self.shortcut, "CmdType": "AlterDoc"}

    def IsActive(self) -> bool:
        try:
            reason = self.reason()
        except Exception as error:  # asked for by a timer: nothing may come out of it
            reason = str(error)
        self._say(reason)
        return not reason

    def Activated(self, index: int = 0) -> None:
        with errors_shown(translate(self.name, self.text)):
            self.run()

    _said: Optional[str] = None

    def _say(self, reason: str) -> None:
        """Puts the reason into tooltip and status tip, since FreeCAD only greys a command out."""
        if reason == self._said:
            return
        command = FreeCADGui.Command.get(self.name)
        if command is None:
            return
        self._said = reason
        tip = translate(self.name, self.tooltip)
        for action in command.getAction():
            action.setToolTip(f"<b>{translate(self.name, self.text)}</b><br>{tip}"
                              + (f"<br><i>{reason}</i>" if reason else ""))
            action.setStatusTip(reason or tip)


class DesignCommand(Command):
    """One that works on a design: that of the selection, or the document's only one."""

    def reason(self) -> str:
        return "" if chosen_design() else no_design()

    def run(self) -> None:
        self.work(chosen_design())

    @abstractmethod
    def work(self, design: Any) -> None:
        """The work on a Design object."""


def no_design() -> str:
    """Says that there is no design to work on."""
    document = FreeCAD.ActiveDocument
    if document is None or not designs(document):
        return translate("CurveUps", "There is no design: make one with New Design or Examples")
    return translate("CurveUps", "There are several designs: select one")


def chosen_design() -> Any:
    """The design that the selection belongs to, or else the only one of the active document; None
    where there is no telling."""
    document = FreeCAD.ActiveDocument
    if document is None:
        return None
    selected = map(design_of, FreeCADGui.Selection.getSelection(document.Name))
    found = {design.Name: design for design in selected if design is not None}
    if not found:
        found = {design.Name: design for design in designs(document)}
    return next(iter(found.values())) if len(found) == 1 else None


def call(function: str, *arguments: str) -> None:
    """Calls a function of curveups.features with arguments as Python text, and records it: the line in the
    macro does the same in a FreeCAD without a window. function: "document.new_design", say. Raises what
    the function raises."""
    FreeCADGui.doCommand(f"from curveups.features import {function.split('.')[0]}")
    FreeCADGui.doCommand(f"{function}({', '.join(arguments)})")


def named(obj: Any) -> str:
    """A document object as Python text."""
    return f"FreeCAD.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"
