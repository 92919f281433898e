# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair: strengthens weak contacts of the present layout."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .run_command import RunCommand


class Repair(RunCommand):
    """CurveUps_Repair"""

    name = "CurveUps_Repair"
    text = QT_TRANSLATE_NOOP("CurveUps_Repair", "Repair")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Repair",
                                "Move tiles and pins of the layout until weak contacts hold")
    shortcut = "C, R"
    which = "repair"


COMMAND = Repair()
