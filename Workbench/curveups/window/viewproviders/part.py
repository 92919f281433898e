# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of the objects below a Design."""

from __future__ import annotations

from typing import Any

from pivy import coin

from .view import View, run_on


class PartView(View):
    """Of an object without a shape: an empty display mode keeps it from being grey in the tree."""

    def attach(self, view: Any) -> None:
        super().attach(view)
        view.addDisplayMode(coin.SoGroup(), "Nothing")

    def getDisplayModes(self, view: Any) -> list[str]:
        return ["Nothing"]

    def getDefaultDisplayMode(self) -> str:
        return "Nothing"


class CutsView(PartView):
    """Of Cuts; a double click opens their own panel."""

    ICON = "CurveUps_Cuts"
    MENU = ("CurveUps_Cuts",)

    def doubleClicked(self, view: Any) -> bool:
        return run_on(self.object, "CurveUps_Cuts")


class LayoutView(PartView):
    """Of a Layout."""

    ICON = "CurveUps_ShowFlat"
    MENU = ("CurveUps_Solve", "CurveUps_Repair", "CurveUps_ShowFlat", "CurveUps_ShowActuated")
    GROUP = "Layout"


class VerificationView(PartView):
    """Of a Verification."""

    ICON = "CurveUps_Verify"
    MENU = ("CurveUps_Verify", "CurveUps_Repair", "CurveUps_WorstContacts", "CurveUps_Overlay")
    GROUP = "Physics"


_BUILT = ("CurveUps_BuildSolids", "CurveUps_ShowSolids", "CurveUps_Export")
# Icon, menu and group of parameters by kind of body; a target has none.
_SHAPES: dict[str, tuple[str, tuple[str, ...], str]] = {
    "": ("CurveUps_Target", ("CurveUps_Target", "CurveUps_Check", "CurveUps_Cuts", "CurveUps_Solve"),
         "Target"),
    "tiles": ("CurveUps_Tiles", _BUILT, "Tiles"),
    "support": ("CurveUps_Support", _BUILT, "Support"),
    "anchors": ("CurveUps_Anchors", _BUILT, "Anchors")}


class ShapeView(View):
    """View of Target, Tiles, Support and Anchors, which FreeCAD draws by itself."""

    def attach(self, view: Any) -> None:
        super().attach(view)
        self.ICON, self.MENU, self.GROUP = _SHAPES[getattr(view.Object, "Kind", "")]
