# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check: which parts of a target can become tiles, before any layout."""

from __future__ import annotations

from .. import runs
from ..panels.check import CheckPanel
from ..qt import QT_TRANSLATE_NOOP
from ..selection import chosen_design
from .command import PanelCommand


class Check(PanelCommand):
    """CurveUps_Check"""

    name = "CurveUps_Check"
    text = QT_TRANSLATE_NOOP("CurveUps_Check", "Check")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Check",
                                "Find out which parts of the target can become tiles, and which sizes "
                                "work, before you solve")
    shortcut = "C, K"
    panel = CheckPanel

    def reason(self) -> str:
        return super().reason() or runs.reason("check", chosen_design())


COMMAND = Check()
