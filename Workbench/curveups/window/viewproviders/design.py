# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object in the tree."""

from __future__ import annotations

from typing import Any

from ...features.proxy import SLOTS
from ..overlay.view import OverlayView
from .view import View


class DesignView(OverlayView, View):
    """Icon of a Design, and what is below it; the overlay, its display, hangs on it."""

    MENU = ("CurveUps_Solve", "CurveUps_Verify", "CurveUps_Repair", "CurveUps_Actuate",
            "CurveUps_BuildSolids", "CurveUps_ShowFlat", "CurveUps_ShowActuated", "CurveUps_ShowSolids",
            "CurveUps_Export", "CurveUps_Report")

    def attach(self, view: Any) -> None:
        View.attach(self, view)
        OverlayView.attach(self, view)

    def updateData(self, obj: Any, name: str) -> None:
        View.updateData(self, obj, name)
        OverlayView.updateData(self, obj, name)

    def setEdit(self, view: Any, mode: int = 0) -> bool:
        """Opens the panel; FreeCAD has no need of an edit mode."""
        self.doubleClicked(view)
        return False

    def claimChildren(self) -> list:
        return [part for slot in SLOTS if (part := getattr(self.object, slot, None)) is not None]

    def onDelete(self, view: Any, names: Any) -> bool:
        """Takes along what is below it, unless something else is made from that."""
        obj = view.Object
        for part in self.claimChildren():
            if all(other == obj or _only_names(other) for other in part.InList):
                obj.Document.removeObject(part.Name)
        return True


def _only_names(obj: Any) -> bool:
    """Whether an object may lose what it links to: a group, or a sheet that reads it."""
    return obj.hasExtension("App::GroupExtension") or obj.TypeId == "Spreadsheet::Sheet"
