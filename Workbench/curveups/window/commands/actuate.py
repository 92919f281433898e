# SPDX-License-Identifier: LGPL-2.1-or-later
"""Actuate: computes the shape of the built piece, and shows the path from flat."""

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
                                "Compute the shape of the built piece: released from flat, shaken, and "
                                "pressed over its former")
    panel = ActuatePanel
    which = "actuate"

    def work(self, design: Any) -> None:
        panel = show(ActuatePanel, design)
        if design.Actuation != "current":
            panel.run()


COMMAND = Actuate()
