# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is below a Design in the tree."""

from __future__ import annotations

from .view import View


class CutsView(View):
    """Of Cuts."""

    ICON = COMMAND = "CurveUps_Cuts"


class LayoutView(View):
    """Of a Layout."""

    ICON = "CurveUps_ShowFlat"
    COMMAND = "CurveUps_Solve"
    MENU = ("CurveUps_Repair", "CurveUps_ShowFlat", "CurveUps_ShowActuated")


class VerificationView(View):
    """Of a Verification."""

    ICON = COMMAND = "CurveUps_Verify"
    MENU = ("CurveUps_Repair", "CurveUps_WorstContacts", "CurveUps_Overlay")
