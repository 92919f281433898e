# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build Solids: the solids of the design with the present parameters."""

from __future__ import annotations

from ..qt import QT_TRANSLATE_NOOP
from .run_command import RunCommand


class BuildSolids(RunCommand):
    """CurveUps_BuildSolids"""

    name = "CurveUps_BuildSolids"
    text = QT_TRANSLATE_NOOP("CurveUps_BuildSolids", "Build Solids")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_BuildSolids",
                                "Build the solids of tiles, support and anchors with the present "
                                "parameters")
    which = "build_solids"


COMMAND = BuildSolids()
