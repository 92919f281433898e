# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts: the edges along which tiles are disconnected."""

from __future__ import annotations

from ...base.native import problem
from ..panels.cuts import CutsPanel
from ..qt import QT_TRANSLATE_NOOP
from ..run import LIVE
from .command import PanelCommand


class Cuts(PanelCommand):
    """CurveUps_Cuts"""

    name = "CurveUps_Cuts"
    text = QT_TRANSLATE_NOOP("CurveUps_Cuts", "Cuts")
    tooltip = QT_TRANSLATE_NOOP(
        "CurveUps_Cuts", "Pick edges along which tiles are disconnected, or ask for suggestions")
    panel = CutsPanel

    def reason(self) -> str:
        return super().reason() or str(problem() or "") or LIVE.obstacle()


COMMAND = Cuts()
