# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fabrication Kit."""

from __future__ import annotations

from ..panels.kit import KitPanel
from ..qt import QT_TRANSLATE_NOOP
from .command import PanelCommand


class Kit(PanelCommand):
    """CurveUps_Kit"""

    name = "CurveUps_Kit"
    text = QT_TRANSLATE_NOOP("CurveUps_Kit", "Fabrication Kit")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Kit",
                                "Write the order for the print shop, templates for the latex and the steps "
                                "of assembly")
    panel = KitPanel
    which = "kit"


COMMAND = Kit()
