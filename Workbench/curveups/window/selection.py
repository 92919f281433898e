# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the design and the tiles that the user selected."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ..features.document import design_of, designs
from .overlays import overlay_of
from .qt import translate


def no_design() -> str:
    """Says that there is no design to work on."""
    document = FreeCAD.ActiveDocument
    if document is None or not designs(document):
        return translate("CurveUps", "There is no design: make one with New Design or Examples")
    return translate("CurveUps", "There are several designs: select one")


def chosen_design() -> Any:
    """The design that the selection belongs to, or else the only one of the active document; None
    where there is no telling."""
    document = FreeCAD.ActiveDocument
    if document is None:
        return None
    selected = map(design_of, FreeCADGui.Selection.getSelection(document.Name))
    found = {design.Name: design for design in selected if design is not None}
    if not found:
        found = {design.Name: design for design in designs(document)}
    return next(iter(found.values())) if len(found) == 1 else None


def select_tiles(link: str) -> None:
    """Selects the tiles that a link names in the overlay of the design at hand."""
    design = chosen_design()
    if design is not None:
        overlay_of(design).select_tiles([int(name[1:]) - 1 for name in link.split(",")])
