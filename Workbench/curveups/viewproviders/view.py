# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all our objects share in the tree."""

from __future__ import annotations

from functools import partial
from typing import Any

import FreeCADGui

from .icons import icon


class View:
    """Icon with a badge of the object's state. Nothing is stored: views are attached on opening."""

    ICON = "CurveUpsWorkbench"
    COMMAND = ""  # that a double click runs, and the first of the context menu
    MENU: tuple[str, ...] = ()

    def __init__(self, view: Any):
        self.object = view.Object
        view.Proxy = self

    def doubleClicked(self, view: Any) -> bool:
        if not self.COMMAND:
            return False
        select(self.object)
        return run(self.COMMAND)

    def setupContextMenu(self, view: Any, menu: Any) -> None:
        known = FreeCADGui.listCommands()
        for name in (self.COMMAND, *self.MENU):
            if name in known:
                command = FreeCADGui.Command.get(name)
                action = menu.addAction(command.getInfo()["menuText"].replace("&", ""))
                action.setEnabled(command.isActive())
                action.triggered.connect(partial(_run_on, self.object, name))

    def attach(self, view: Any) -> None:
        self.object = view.Object

    def updateData(self, obj: Any, name: str) -> None:
        if name == "Status":
            obj.ViewObject.signalChangeIcon()

    def getIcon(self) -> Any:
        return icon(self.ICON, getattr(self.object, "Status", ""))

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        self.object = None

    __getstate__ = dumps
    __setstate__ = loads


def select(obj: Any) -> None:
    """Makes `obj` the selection: commands work on that."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name)


def run(command: str) -> bool:
    """Runs a command of ours, after the workbench has made them known; whether there is one."""
    if command not in FreeCADGui.listCommands():
        from .. import commands

        commands.register()
    if command not in FreeCADGui.listCommands():
        return False
    FreeCADGui.runCommand(command)
    return True


def _run_on(obj: Any, command: str, *_: Any) -> None:
    select(obj)
    run(command)
