# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists the commands, one file each, as toolbar and menu show them."""

from __future__ import annotations

import importlib
from typing import Any

from ..qt import QT_TRANSLATE_NOOP

# The way from a surface to print files: the toolbar, and the head of the menu.
_STEPS = ("new_design", "check", "solve", "cuts", "overlay", "export")
# What follows in the menu: menus below it by their names, and what stands there by itself.
_MENUS = (
    (QT_TRANSLATE_NOOP("Workbench", "Design"),
     ("target", "verify", "repair", "actuate", "build_solids", "report", "kit")),
    (QT_TRANSLATE_NOOP("Workbench", "Show"), ("show_flat", "show_actuated", "show_solids", "worst_contacts")),
    ("", ("examples",)),
    (QT_TRANSLATE_NOOP("Workbench", "Help"), ("guide", "solver_status")))
MENU = QT_TRANSLATE_NOOP("Workbench", "&CurveUps")


def steps() -> list[str]:
    """Names of the commands of the toolbar."""
    return [_command(file).name for file in _STEPS]


def menus() -> list[tuple[list[str], list[str]]]:
    """Titles on the way to a menu, for FreeCAD to translate, and names of what stands there."""
    found = [([MENU], [*steps(), "Separator"])]
    for title, files in _MENUS:
        found.append(([MENU, title] if title else [MENU], [_command(file).name for file in files]))
    return found


def register() -> None:
    """Makes all commands known to FreeCAD."""
    import FreeCADGui

    for file in (*_STEPS, *(file for _, files in _MENUS for file in files)):
        command = _command(file)
        for one in (*command.menu(), command):
            FreeCADGui.addCommand(one.name, one)


def _command(file: str) -> Any:
    return importlib.import_module(f"{__name__}.{file}").COMMAND
