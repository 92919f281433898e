# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show Flat: the tiles in the flat layout."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .showing import ShowCommand


class ShowFlat(ShowCommand):
    """CurveUps_ShowFlat"""

    name = "CurveUps_ShowFlat"
    text = QT_TRANSLATE_NOOP("CurveUps_ShowFlat", "Show Flat")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_ShowFlat", "Show the tiles in the flat layout")
    function = "show_flat"
    needs_layout = True


COMMAND = ShowFlat()
