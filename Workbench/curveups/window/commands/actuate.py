# SPDX-License-Identifier: LGPL-2.1-or-later
"""Actuate: lets the piece rise from flat, and shows the path."""

from __future__ import annotations

from typing import Any

from ..panels.actuate import ActuatePanel
from ..panels.panel import show
from ..qt import QT_TRANSLATE_NOOP
from .command import PanelCommand


class Actuate(PanelCommand):
    """CurveUps_Actuate"""

    name = "CurveUps_Actuate"
    text = QT_TRANSLATE_NOOP("CurveUps_Actuate", "Actuate")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Actuate",
                                "Let the piece rise from flat under its membranes, and find out whether it "
                                "arrives by itself and what holds it back")
    panel = ActuatePanel
    which = "actuate"

    def work(self, design: Any) -> None:
        panel = show(ActuatePanel, design)
        if design.Actuation != "current":
            panel.run()


COMMAND = Actuate()
