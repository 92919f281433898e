# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: how FreeCAD sees them, why one can't run, errors, transactions, macros."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Sequence

import FreeCADGui

from .. import runs
from ..notice import errors_shown
from ..panels.panel import Panel, obstacle, show
from ..qt import translate
from ..selection import chosen_design, no_design


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


class DesignCommand(Command):
    """One that works on a design: that of the selection, or the document's only one."""

    def reason(self) -> str:
        return "" if chosen_design() else no_design()

    def run(self) -> None:
        self.work(chosen_design())

    @abstractmethod
    def work(self, design: Any) -> None:
        """The work on a Design object."""


class PanelCommand(DesignCommand):
    """One that opens a panel. `which`: the run (runs.reason) that the panel is for, if it is for one."""

    panel: type[Panel]
    which = ""

    def reason(self) -> str:
        found = super().reason() or obstacle()
        return found or (runs.reason(self.which, chosen_design()) if self.which else "")

    def work(self, design: Any) -> None:
        show(self.panel, design)
