# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is below a Design in the tree."""

from __future__ import annotations

from typing import Any

from pivy import coin

from .view import View


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
    """Of Cuts."""

    ICON = COMMAND = "CurveUps_Cuts"


class LayoutView(PartView):
    """Of a Layout."""

    ICON = "CurveUps_ShowFlat"
    COMMAND = "CurveUps_Solve"
    MENU = ("CurveUps_Repair", "CurveUps_ShowFlat", "CurveUps_ShowActuated")


class VerificationView(PartView):
    """Of a Verification."""

    ICON = COMMAND = "CurveUps_Verify"
    MENU = ("CurveUps_Repair", "CurveUps_WorstContacts", "CurveUps_Overlay")
