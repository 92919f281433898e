# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of the design for the parameters as they are."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .run_command import RunCommand


class BuildSolids(RunCommand):
    """CurveUps_BuildSolids"""

    name = "CurveUps_BuildSolids"
    text = QT_TRANSLATE_NOOP("CurveUps_BuildSolids", "Build Solids")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_BuildSolids",
                                "Make tiles, support and anchors as solids, for the parameters as they are")
    shortcut = ""
    which = "build_solids"


COMMAND = BuildSolids()
