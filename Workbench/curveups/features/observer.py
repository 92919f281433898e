# SPDX-License-Identifier: LGPL-2.1-or-later
"""Watches documents from FreeCAD's start: what was opened is made whole (document.py).

Loads nothing heavy: documents of others cost a look at their objects' types.
"""

from __future__ import annotations

from typing import Any

_OF_TARGETS = ("Source", "File", "BuiltIn", "KeepMesh")


class Restorer:
    """A document observer. FreeCAD tells Python of the end of opening a document only by making that
    document the active one."""

    def slotChangedObject(self, obj: Any, name: str) -> None:
        if name in _OF_TARGETS and getattr(obj, "CurveUpsType", "") == "CurveUps::Target":
            from . import target

            if "Stamp" in obj.PropertiesList and not obj.Document.Restoring:
                target.notice(obj)

    def slotUndoDocument(self, document: Any) -> None:
        # Shapes are in no transaction, and what was undone may be a state that is none any more.
        from .proxy import designs

        for design in designs(document):
            if design.Proxy is not None:
                design.Proxy.refresh(design)

    slotRedoDocument = slotUndoDocument
    slotAbortTransaction = slotUndoDocument

    def slotActivateDocument(self, document: Any) -> None:
        if any("CurveUpsType" in obj.PropertiesList for obj in document.Objects):
            from . import document as documents

            documents.opened(document)


def install() -> None:
    """Once for each FreeCAD."""
    import FreeCAD

    if getattr(FreeCAD, "curveups_restorer", None) is None:
        FreeCAD.curveups_restorer = Restorer()
        FreeCAD.addDocumentObserver(FreeCAD.curveups_restorer)
