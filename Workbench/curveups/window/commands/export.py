# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export Print Files."""

from __future__ import annotations

from ..panels.export import ExportPanel
from ..qt import QT_TRANSLATE_NOOP
from .command import PanelCommand


class Export(PanelCommand):
    """CurveUps_Export"""

    name = "CurveUps_Export"
    text = QT_TRANSLATE_NOOP("CurveUps_Export", "Export Print Files")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Export",
                                "Write 3MF, STEP and STL files of the bodies, and the report for the print "
                                "shop")
    shortcut = "C, E"
    panel = ExportPanel
    which = "export"


COMMAND = Export()
