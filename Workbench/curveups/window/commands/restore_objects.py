# SPDX-License-Identifier: LGPL-2.1-or-later
"""CurveUps_RestoreObjects: gives objects their behaviour back that a FreeCAD without CurveUps took."""

from __future__ import annotations

import FreeCAD

from ...features import registry
from ..qt import QT_TRANSLATE_NOOP, translate
from .command import Command


class RestoreObjects(Command):
    """What opening a document does by itself, for those that were opened before the workbench was there."""

    name = "CurveUps_RestoreObjects"
    text = QT_TRANSLATE_NOOP("CurveUps_RestoreObjects", "Restore Objects")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_RestoreObjects",
                                "Restore designs that a FreeCAD without CurveUps saved")

    def reason(self) -> str:
        return "" if FreeCAD.ActiveDocument else translate("CurveUps", "There is no document")

    def run(self) -> None:
        mended = registry.restore(FreeCAD.ActiveDocument)
        said = translate("CurveUps", "objects that were restored: {count}", count=len(mended))
        FreeCAD.Console.PrintMessage(f"{said}\n")


COMMAND = RestoreObjects()
