# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verify: decides whether the present layout is valid."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .run_command import RunCommand


class Verify(RunCommand):
    """CurveUps_Verify"""

    name = "CurveUps_Verify"
    text = QT_TRANSLATE_NOOP("CurveUps_Verify", "Verify")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Verify",
                                "Decide whether the present layout is valid with the present tiles and "
                                "membranes")
    shortcut = "C, V"
    which = "verify"


COMMAND = Verify()
