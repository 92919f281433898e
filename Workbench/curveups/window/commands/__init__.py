# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists the commands as toolbar and menu show them."""

from __future__ import annotations

import FreeCADGui

from ..qt import QT_TRANSLATE_NOOP
from . import designs, help, new_design

# The way from a surface to print files: the toolbar, and the head of the menu.
_STEPS = ("CurveUps_NewDesign", "CurveUps_Check", "CurveUps_Solve", "CurveUps_Cuts", "CurveUps_Overlay",
          "CurveUps_Export")
# What follows in the menu: menus below it by their names, and what stands there by itself.
_MENUS = (
    (QT_TRANSLATE_NOOP("Workbench", "Design"),
     ("CurveUps_Target", "CurveUps_Verify", "CurveUps_Repair", "CurveUps_LittleFriction", "CurveUps_Actuate",
      "CurveUps_BuildSolids", "CurveUps_Report", "CurveUps_Kit")),
    (QT_TRANSLATE_NOOP("Workbench", "Show"),
     ("CurveUps_ShowFlat", "CurveUps_ShowActuated", "CurveUps_ShowSolids", "CurveUps_WorstContacts")),
    ("", ("CurveUps_Examples",)),
    (QT_TRANSLATE_NOOP("Workbench", "Help"), ("CurveUps_Guide", "CurveUps_SolverStatus")))
MENU = QT_TRANSLATE_NOOP("Workbench", "&CurveUps")


def steps() -> list[str]:
    """Names of the commands of the toolbar."""
    return list(_STEPS)


def menus() -> list[tuple[list[str], list[str]]]:
    """Titles on the way to a menu, for FreeCAD to translate, and names of what stands there."""
    return [([MENU], [*_STEPS, "Separator"]),
            *(([MENU, title] if title else [MENU], list(names)) for title, names in _MENUS)]


def register() -> None:
    """Makes all commands known to FreeCAD."""
    for command in (new_design.NewDesign(), new_design.Examples(), *designs.COMMANDS, help.Guide(),
                    help.SolverStatus()):
        for one in (*command.menu(), command):
            FreeCADGui.addCommand(one.name, one)
