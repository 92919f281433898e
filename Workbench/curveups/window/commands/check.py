# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check: which parts of a target can become tiles, before any layout."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .. import runs
from ..panels.check import CheckPanel
from ..qt import QT_TRANSLATE_NOOP, translate
from ..selection import chosen_design
from .command import DesignCommand


class Check(DesignCommand):
    """CurveUps_Check"""

    name = "CurveUps_Check"
    text = QT_TRANSLATE_NOOP("CurveUps_Check", "Check")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Check",
                                "Find out which parts of the target can become tiles, and which sizes "
                                "work, before you solve")
    shortcut = "C, K"

    def reason(self) -> str:
        found = super().reason() or runs.reason("check", chosen_design())
        if not found and FreeCADGui.Control.activeDialog():
            found = translate("CurveUps", "Another task panel is open: close it first")
        return found

    def work(self, design: Any) -> None:
        FreeCADGui.Control.showDialog(CheckPanel(design))


COMMAND = Check()
