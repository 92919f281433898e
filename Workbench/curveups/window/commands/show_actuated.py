# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show Actuated: the tiles in the target shape."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .showing import ShowCommand


class ShowActuated(ShowCommand):
    """CurveUps_ShowActuated"""

    name = "CurveUps_ShowActuated"
    text = QT_TRANSLATE_NOOP("CurveUps_ShowActuated", "Show Actuated")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_ShowActuated", "Show the tiles in the target shape")
    function = "show_actuated"


COMMAND = ShowActuated()
