# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registry of overlays: commands, panels and runs get theirs from `overlay_of(design)`."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ..features.document import design_of, designs
from .qt import translate

_OVERLAYS: dict[tuple[str, str], Any] = {}  # by names of document and object


def add(design: Any, overlay: Any) -> None:
    """Register the Overlay of a Design object."""
    _OVERLAYS[design.Document.Name, design.Name] = overlay


def overlay_of(design: Any) -> Any:
    """Overlay of a Design object. Raises KeyError where it has none: without a window, or a design that never
    got its view."""
    key = (design.Document.Name, design.Name)
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
