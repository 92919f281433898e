# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observers of FreeCAD for overlays: selection of tiles, deleted documents, the unit schema."""

from __future__ import annotations

import re
from contextlib import suppress
from typing import Any, Callable, Optional

import FreeCAD
import FreeCADGui

from ...features.document import designs
from ..overlays import forget, overlay_of, overlays
from ..qt import QtCore

_TILE = re.compile(r"(?:^|\.)T(\d{5,})$")
_started: Optional[tuple] = None
_UNITS = "User parameter:BaseApp/Preferences/Units"
unit_observers: list[Callable[[], None]] = []  # called when the unit schema has changed


def start() -> None:
    """Observe FreeCAD, once a session."""
    global _started
    if _started is None:
        _started = (_Selection(), _Documents(), _Units())
        FreeCADGui.Selection.addObserver(_started[0])
        FreeCAD.addDocumentObserver(_started[1])


def tile_in(element: str) -> int:
    """Tile that the name of a sub-element ends with; -1 for other names."""
    match = _TILE.search(element)
    return int(match[1]) - 1 if match else -1


def selected_tiles(design: Any) -> list[int]:
    """Tiles of a Design that are selected, in the order of their selection."""
    for selected in FreeCADGui.Selection.getSelectionEx(design.Document.Name):
        if selected.ObjectName == design.Name:
            return [tile for tile in map(tile_in, selected.SubElementNames) if tile >= 0]
    return []


class _Selection:
    def __init__(self) -> None:
        self._hovered: tuple[str, str, str] = ("", "", "")

    def addSelection(self, document: str, name: str, element: str, point: Any) -> None:
        self._tell(document, element)

    def clearSelection(self, document: str, *_: str) -> None:
        self._tell(document)

    removeSelection = setSelection = clearSelection

    def setPreselection(self, document: str, name: str, element: str) -> None:
        self._hovered = (document, name, element)
        self._tell(document)

    def removePreselection(self, document: str, name: str, element: str) -> None:
        self._hovered = ("", "", "")
        self._tell(document)

    def _tell(self, document: str, element: str = "") -> None:
        for overlay in overlays(document or ""):
            design = overlay.object
            here = self._hovered[:2] == (design.Document.Name, design.Name)
            hovered = tile_in(self._hovered[2]) if here else -1
            selected = selected_tiles(design)
            overlay.mark_selected(selected, [hovered] if hovered >= 0 else [])
            tile = tile_in(element)
            if tile >= 0 and tile in selected:
                values = "; ".join(f"{title} {value}" for title, value in overlay.values_of(tile))
                FreeCADGui.getMainWindow().statusBar().showMessage(f"{element}: {values}", 60_000)


class _Units:
    """Observer of the user's unit schema."""

    def __init__(self) -> None:
        self._group = FreeCAD.ParamGet(_UNITS)
        self._group.Attach(self)

    def onChange(self, group: Any, name: str) -> None:
        QtCore.QTimer.singleShot(0, self._show)  # FreeCAD sets the schema after the preference

    def _show(self) -> None:
        for overlay in overlays():
            overlay.explain()
        for observer in list(unit_observers):
            observer()


class _Documents:
    def slotDeletedDocument(self, document: Any) -> None:
        forget(document.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        forget(obj.Document.Name, obj.Name)

    def slotUndoDocument(self, document: Any) -> None:
        for design in designs(document):
            with suppress(KeyError):  # it never had one
                overlay_of(design)

    slotRedoDocument = slotUndoDocument
