# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solve: leads from the target to a verified layout."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .run_command import RunCommand


class Solve(RunCommand):
    """CurveUps_Solve"""

    name = "CurveUps_Solve"
    text = QT_TRANSLATE_NOOP("CurveUps_Solve", "Solve")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Solve",
                                "Lay the tiles out flat, verify that the membranes hold the shape, and "
                                "repair weak contacts")
    shortcut = "C, S"
    which = "solve"


COMMAND = Solve()
