# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overlays of designs, which `overlay_of(design)` gives, and the observers of FreeCAD that they follow:
selection of tiles, deleted documents, the unit schema."""

from __future__ import annotations

import re
from contextlib import suppress
from html import escape
from typing import Any

import FreeCAD
import FreeCADGui

from ..base.errors import tile_name
from ..features.document import design_of, designs
from .qt import QtCore, QtGui, QtWidgets, translate

Place = tuple[str, str]  # names of a document and an object
_OVERLAYS: dict[Place, Any] = {}
_TILE = re.compile(r"(?:^|\.)T(\d{5,})$")
_observer: Any = None
_UNITS = "User parameter:BaseApp/Preferences/Units"


def place_of(design: Any) -> Place:
    """Names by which a Design is found again, or is known to be gone."""
    return design.Document.Name, design.Name


def add(design: Any, overlay: Any) -> None:
    """Register the Overlay of a Design object."""
    _OVERLAYS[place_of(design)] = overlay


def overlay_of(design: Any) -> Any:
    """Overlay of a Design object. Raises KeyError where it has none: without a window, or a design that never
    got its view."""
    key = place_of(design)
    if key not in _OVERLAYS:
        # Undone deletions bring a view provider back without attaching it anew.
        kept = getattr(getattr(design.ViewObject, "Proxy", None), "overlay", None)
        if kept is None:
            raise KeyError(key)
        _OVERLAYS[key] = kept
        kept.closed = False
        kept.refresh()
    return _OVERLAYS[key]


def overlays(document: str = "") -> list:
    """All overlays, or those of a document by its name."""
    return [overlay for (name, _), overlay in _OVERLAYS.items() if document in ("", name)]


def forget(document: str, name: str = "") -> None:
    """Close a document's overlays, or one by the name of its object."""
    for key in [key for key in _OVERLAYS if key[0] == document and name in ("", key[1])]:
        _OVERLAYS.pop(key).close()


def no_design() -> str:
    """Reason why there is no design to work on."""
    document = FreeCAD.ActiveDocument
    if document is None or not designs(document):
        return translate("CurveUps", "There is no design: make one with New Design or Examples")
    return translate("CurveUps", "There are several designs: select one")


def chosen_design() -> Any:
    """Design that the selection belongs to, or else the only one of the active document; None where there are
    several or none."""
    document = FreeCAD.ActiveDocument
    if document is None:
        return None
    selected = map(design_of, FreeCADGui.Selection.getSelection(document.Name))
    by_name = {design.Name: design for design in selected if design is not None}
    by_name = by_name or {design.Name: design for design in designs(document)}
    return next(iter(by_name.values())) if len(by_name) == 1 else None


def select_tiles(link: str) -> None:
    """Select the tiles that a link names in the overlay of the chosen design."""
    design = chosen_design()
    if design is not None:
        overlay_of(design).select_tiles([int(name[1:]) - 1 for name in link.split(",")])


def start() -> None:
    """Observe FreeCAD, once a session."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCADGui.Selection.addObserver(_observer)
        FreeCAD.addDocumentObserver(_observer)


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


def _show_at_pointer(title: str, values: list[tuple[str, str]]) -> None:
    """Show values of a tile in a small table where it was clicked; lists and links show them elsewhere."""
    place = QtGui.QCursor.pos()
    below, views = QtWidgets.QApplication.widgetAt(place), FreeCADGui.getMainWindow().centralWidget()
    if below is None or not views.isAncestorOf(below):
        return
    rows = "".join(f"<tr><td>{escape(name)}&nbsp;&nbsp;</td><td>{escape(value)}</td></tr>"
                   for name, value in values)
    QtWidgets.QToolTip.showText(place, f"<b>{title}</b><table>{rows}</table>", below)


class _Observer:
    """Observer of the selection, of documents and of the user's unit schema."""

    def __init__(self) -> None:
        self._hovered: tuple[str, str, str] = ("", "", "")
        self._units = FreeCAD.ParamGet(_UNITS)
        self._units.Attach(self)

    def addSelection(self, document: str, name: str, element: str, point: Any) -> None:
        self._tell(document, element)

    def clearSelection(self, document: str, *_: str) -> None:
        self._tell(document)

    removeSelection = setSelection = clearSelection

    def setPreselection(self, document: str, name: str = "", element: str = "") -> None:
        self._hovered = (document, name, element)
        self._tell(document)

    def removePreselection(self, document: str, *_: str) -> None:
        self.setPreselection(document)

    def _tell(self, document: str, element: str = "") -> None:
        for overlay in overlays(document or ""):
            design = overlay.object
            here = self._hovered[:2] == place_of(design)
            hovered = tile_in(self._hovered[2]) if here else -1
            selected = selected_tiles(design)
            overlay.mark_selected(selected, [hovered] if hovered >= 0 else [])
            tile = tile_in(element)
            if tile >= 0 and tile in selected:
                _show_at_pointer(tile_name(tile), overlay.values_of(tile))

    def onChange(self, group: Any, name: str) -> None:
        # FreeCAD sets the schema after the preference.
        QtCore.QTimer.singleShot(0, lambda: [overlay.explain() for overlay in overlays()])

    def slotDeletedDocument(self, document: Any) -> None:
        forget(document.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        forget(obj.Document.Name, obj.Name)

    def slotUndoDocument(self, document: Any) -> None:
        for design in designs(document):
            with suppress(KeyError):  # it never had one
                overlay_of(design)

    slotRedoDocument = slotUndoDocument
