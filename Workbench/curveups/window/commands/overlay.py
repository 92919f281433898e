# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overlay: the value that colours the tiles, and their place between flat and actuated."""

from __future__ import annotations

from ..panels.overlay import OverlayPanel
from ..qt import QT_TRANSLATE_NOOP
from ..selection import chosen_design
from .command import PanelCommand
from .showing import missing


class OverlayCommand(PanelCommand):
    """CurveUps_Overlay"""

    name = "CurveUps_Overlay"
    text = QT_TRANSLATE_NOOP("CurveUps_Overlay", "Overlay")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Overlay",
                                "Choose the value that colours the tiles, fold them, and read their values")
    panel = OverlayPanel

    def reason(self) -> str:
        return super().reason() or missing(chosen_design(), layout=False)


COMMAND = OverlayCommand()
