# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: how FreeCAD sees them, why one can't run, errors, transactions, macros."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Callable, Sequence

import FreeCADGui

from ..notice import errors_shown
from ..overlays import chosen_design, no_design
from ..qt import translate


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

    def menu(self) -> "Sequence[Command]":
        """The commands that this one is a menu of."""
        return []

    def GetResources(self) -> dict[str, Any]:
        return {"Pixmap": self.name, "MenuText": self.text, "ToolTip": self.tooltip, "WhatsThis": self.name,
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

    def _say(self, reason: str) -> None:
        """Puts the reason into tooltip and status tip, since FreeCAD only greys a command out. FreeCAD takes
        it out of them when the language changes."""
        command = FreeCADGui.Command.get(self.name)
        actions = command.getAction() if command is not None else []
        for action, one in zip(actions, self.menu() or (self,)):  # a menu's are its items
            tip = translate(one.name, one.tooltip)
            shown = (f"<b>{translate(one.name, one.text)}</b><br>{tip}"
                     + (f"<br><i>{reason}</i>" if reason else ""))
            if action.toolTip() == shown:
                return
            action.setToolTip(shown)
            action.setStatusTip(reason or tip)


Work = Callable[[Any], object]   # on a Design object
Reason = Callable[[Any], str]    # why nothing can be done with a Design object; empty where it can


class DesignCommand(Command):
    """Works on a design: that of the selection, or the document's only one. reasons: asked in their order."""

    def __init__(self, name: str, text: str, tooltip: str, work: Work, *reasons: Reason, shortcut: str = ""):
        self.name, self.text, self.tooltip, self.shortcut = name, text, tooltip, shortcut
        self._work, self._reasons = work, reasons

    def reason(self) -> str:
        design = chosen_design()
        if design is None:
            return no_design()
        return next(filter(None, (reason(design) for reason in self._reasons)), "")

    def run(self) -> None:
        self._work(chosen_design())
