# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show Solids: the bodies of the print instead of the overlay."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP, translate
from ..selection import chosen_design
from .showing import ShowCommand


class ShowSolids(ShowCommand):
    """CurveUps_ShowSolids"""

    name = "CurveUps_ShowSolids"
    text = QT_TRANSLATE_NOOP("CurveUps_ShowSolids", "Show Solids")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_ShowSolids",
                                "Show tiles and anchors as printed solids. They are exact, but slow for "
                                "thousands of tiles")
    function = "show_solids"
    needs_layout = True

    def reason(self) -> str:
        found = super().reason()
        tiles = None if found else getattr(chosen_design(), "Tiles", None)
        if not found and (tiles is None or tiles.Shape.isNull()):
            found = translate("CurveUps", "There are no solids yet: run Build Solids")
        return found


COMMAND = ShowSolids()
