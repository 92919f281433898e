# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export Print Files."""

from __future__ import annotations

from typing import Any

from ..panels.export import open_panel
from ..qt import QT_TRANSLATE_NOOP
from ..runs import reason
from ..selection import chosen_design
from .command import DesignCommand


class Export(DesignCommand):
    """CurveUps_Export"""

    name = "CurveUps_Export"
    text = QT_TRANSLATE_NOOP("CurveUps_Export", "Export Print Files")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Export",
                                "Write 3MF, STEP and STL files of the bodies, and the report for the print "
                                "shop")
    shortcut = "C, E"

    def reason(self) -> str:
        return super().reason() or reason("export", chosen_design())

    def work(self, design: Any) -> None:
        open_panel(design)


COMMAND = Export()
