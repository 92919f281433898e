# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of all views in the tree."""

from __future__ import annotations

from functools import partial
from typing import Any

import FreeCADGui

from ...features.proxy import design_of
from .. import commands
from ..notice import errors_shown
from ..panels.panel import show
from ..panels.solve import SolvePanel
from .icons import icon


class View:
    """Icon with a badge of the object's state. FreeCAD stores the class, and attaches it on opening."""

    ICON = "CurveUpsWorkbench"
    MENU: tuple[str, ...] = ()  # commands
    GROUP = ""  # of the parameters that the panel shows after a double click

    def __init__(self, view: Any):
        self.object = view.Object
        view.Proxy = self

    def doubleClicked(self, view: Any) -> bool:
        """Opens the design's panel."""
        design = design_of(self.object)
        if design is not None:
            with errors_shown(""):
                show(SolvePanel, design).turn_to(self.GROUP)
        return design is not None

    def setupContextMenu(self, view: Any, menu: Any) -> None:
        for name in self.MENU:
            if known(name):
                command = FreeCADGui.Command.get(name)
                action = menu.addAction(command.getInfo()["menuText"].replace("&", ""))
                action.setEnabled(command.isActive())
                action.triggered.connect(partial(run_on, self.object, name))

    def attach(self, view: Any) -> None:
        self.object = view.Object

    def updateData(self, obj: Any, name: str) -> None:
        if name == "Status":
            obj.ViewObject.signalChangeIcon()

    def getIcon(self) -> Any:
        return icon(self.ICON, getattr(self.object, "Status", ""))

    def dumps(self) -> Any:
        return None

    def loads(self, state: Any) -> None:
        self.object = None

    __getstate__ = dumps
    __setstate__ = loads


def select(obj: Any) -> None:
    """Makes `obj` the selection: commands work on that."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name)


def known(command: str) -> bool:
    """Whether there is a command of ours; makes them known where the workbench was not active yet."""
    if command not in FreeCADGui.listCommands():
        commands.register()
    return command in FreeCADGui.listCommands()


def run_on(obj: Any, command: str, *_: Any) -> bool:
    """Runs a command of ours on what `obj` belongs to; whether there is one."""
    select(obj)
    if not known(command):
        return False
    FreeCADGui.runCommand(command)
    return True
