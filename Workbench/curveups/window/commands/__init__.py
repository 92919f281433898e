# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists the commands, one file each, in the order of the toolbar."""

from __future__ import annotations

import importlib
from typing import Any

_FILES = ("new_design", "target", "check", "cuts", "solve", "verify", "repair", "build_solids",
          "show_flat", "show_actuated", "show_solids", "overlay", "worst_contacts", "export", "report",
          "examples", "restore_objects", "solver_status")
# What a right click on a design, or beside it, is likely to want.
_CONTEXT = ("solve", "verify", "check", "cuts", "show_flat", "show_actuated", "show_solids", "export",
            "report")


def register() -> tuple[str, ...]:
    """Makes all commands known to FreeCAD; their names in the order of the toolbar."""
    import FreeCADGui

    found = [_command(file) for file in _FILES]
    for command in found:
        for one in (*command.menu(), command):
            FreeCADGui.addCommand(one.name, one)
    return tuple(command.name for command in found)


def for_context(recipient: str) -> list[str]:
    """Names for the context menu of the tree or the view ("tree", "view") as things stand: what can't
    run is left out."""
    found = [_command(file) for file in _CONTEXT]
    return [command.name for command in found if not command.reason()]


def _command(file: str) -> Any:
    return importlib.import_module(f"{__name__}.{file}").COMMAND
