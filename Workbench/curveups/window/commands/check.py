# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check: which parts of a target can become tiles, before any layout."""

from __future__ import annotations

from ..panels.check import CheckPanel
from ..qt import QT_TRANSLATE_NOOP
from .command import PanelCommand


class Check(PanelCommand):
    """CurveUps_Check"""

    name = "CurveUps_Check"
    text = QT_TRANSLATE_NOOP("CurveUps_Check", "Check")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Check",
                                "Find out which parts of the target can become tiles, before you "
                                "solve")
    shortcut = "C, K"
    panel = CheckPanel
    which = "check"


COMMAND = Check()
