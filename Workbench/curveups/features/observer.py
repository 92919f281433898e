# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observer of documents from FreeCAD's start on: it completes documents that were opened, and brings states
up to date after an undo, which no recompute follows.

It loads nothing heavy: documents of others cost a look at their objects' types.
"""

from __future__ import annotations

from typing import Any

from . import proxy


class Observer:
    """A document observer. FreeCAD tells Python of the end of opening a document only by making that
    document the active one."""

    def slotUndoDocument(self, document: Any) -> None:
        for design in proxy.designs(document):
            if design.Proxy is not None:
                from . import status

                to_build = status.refresh(design).to_build
                if proxy.build_later is not None:  # shapes are in no transaction
                    proxy.build_later(design, to_build)

    slotRedoDocument = slotUndoDocument
    slotAbortTransaction = slotUndoDocument

    def slotActivateDocument(self, document: Any) -> None:
        if any(map(proxy.type_of, document.Objects)):
            from . import document as documents

            documents.opened(document)


def install() -> None:
    """Observe documents, once in each FreeCAD."""
    import FreeCAD

    if getattr(FreeCAD, "curveups_observer", None) is None:
        FreeCAD.curveups_observer = Observer()
        FreeCAD.addDocumentObserver(FreeCAD.curveups_observer)
