# SPDX-License-Identifier: LGPL-2.1-or-later
"""CurveUps_RestoreObjects: gives objects their behaviour back that a FreeCAD without CurveUps took."""

from __future__ import annotations

from typing import Any

import FreeCAD

from ...features import registry
from ..macro import call
from ..qt import QT_TRANSLATE_NOOP, translate
from ..viewproviders.attaching import lacks_view
from .command import Command


class RestoreObjects(Command):
    """What opening a document does by itself, for those that were opened before the workbench was there."""

    name = "CurveUps_RestoreObjects"
    text = QT_TRANSLATE_NOOP("CurveUps_RestoreObjects", "Restore Objects")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_RestoreObjects",
                                "Restore designs that a FreeCAD without CurveUps saved")

    def reason(self) -> str:
        if FreeCAD.ActiveDocument is None:
            return translate("CurveUps", "There is no document")
        return "" if _lost() else translate("CurveUps", "There is nothing to restore")

    def run(self) -> None:
        count = len(_lost())
        call("registry.restore", f"FreeCAD.getDocument({FreeCAD.ActiveDocument.Name!r})")
        said = translate("CurveUps", "objects that were restored: {count}", count=count)
        FreeCAD.Console.PrintMessage(f"{said}\n")


def _lost() -> list[Any]:
    return list(filter(
        lambda obj: registry.is_lost(obj) or lacks_view(obj), FreeCAD.ActiveDocument.Objects))


COMMAND = RestoreObjects()
