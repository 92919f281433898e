# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles that carry a design (HeldTiles), picked in the view: each click or stroke is a step of undo."""

from __future__ import annotations

from typing import Any, Callable, Iterable, Optional

import numpy as np

from ...base.errors import tile_name
from ...features.actions import transaction
from ..macro import assign
from ..notice import errors_shown
from ..overlay.pick_tool import PickTool
from ..overlay.picking import Pick
from ..overlay.watching import tile_in
from ..overlays import overlay_of
from ..qt import QtCore, QtWidgets, translate
from .panel import enable


class HeldTiles:
    """`button` starts and ends picking. changed: called after the property was set."""

    def __init__(self, design: Any, changed: Callable[[], object]):
        self._design, self._changed = design, changed
        self._overlay = overlay_of(design)
        self._tool: Optional[PickTool] = None
        self._stroke: list[int] = []
        self.button = button = QtWidgets.QToolButton()
        button.setObjectName("pick_held_tiles")
        button.setText(translate("CurveUpsSolve", "Pick"))
        button.setCheckable(True)
        button.setToolTip(translate(
            "CurveUpsSolve", "Click tiles in the view to hold or release them. Drag with Shift to hold all "
                             "tiles below the mouse. Click a held tile with Ctrl to hold the tiles around "
                             "its patch too"))
        button.toggled.connect(lambda on: self._begin() if on else self.close())
        self.show()

    def show(self) -> None:
        """The design has changed."""
        held = self._design.Gravity == "held"
        enable(self.button, "" if held else translate("CurveUpsSolve", "Set Gravity to held first"))
        if self._tool is not None:
            self._overlay.select_tiles(self.tiles())

    def close(self) -> None:
        """The mouse is FreeCAD's again."""
        if self._tool is not None:
            self._tool.close()
            self._tool = None

    def tiles(self) -> list[int]:
        """That are listed."""
        found = (tile_in(name.strip()) for name in self._design.HeldTiles.split(","))
        return [tile for tile in found if tile >= 0]

    def _begin(self) -> None:
        self._tool = PickTool(self._design, lambda found: None, self._click, self._end, self._paint)
        self.show()

    def _end(self) -> bool:
        self.button.setChecked(False)
        return True

    def _click(self, found: Pick) -> None:
        held, scene = self.tiles(), self._overlay.scene
        if found.tile in held and QtWidgets.QApplication.keyboardModifiers() & QtCore.Qt.ControlModifier:
            self._set({*held, *ring(scene.F, patch(scene.F, held, found.tile))})
        else:
            self._set({*held} ^ {found.tile})

    def _paint(self, found: Optional[Pick]) -> None:
        if found is not None:
            self._stroke.append(found.tile)
            self._overlay.select_tiles([*self.tiles(), *self._stroke])
        else:
            stroke, self._stroke = self._stroke, []
            self._set({*self.tiles(), *stroke})

    def _set(self, tiles: Iterable[int]) -> None:
        title = translate("CurveUpsSolve", "Pick held tiles")
        with errors_shown(title), transaction(self._design.Document, title):
            assign(self._design, "HeldTiles", ",".join(map(tile_name, sorted(tiles))))
            self._design.Document.recompute()
        self._changed()
        self.show()


def ring(F: np.ndarray, tiles: Iterable[int]) -> set[int]:
    """Tiles (rows of F) that have a corner in common with some of these, and these."""
    corners = np.unique(F[sorted(tiles)])
    return set(np.flatnonzero(np.isin(F, corners).any(axis=1)).tolist())


def patch(F: np.ndarray, tiles: Iterable[int], start: int) -> set[int]:
    """Those of the tiles that hang together with one of them by corners."""
    found, grown, among = {start}, {start}, set(tiles)
    while grown:
        grown = (ring(F, found) & among) - found
        found |= grown
    return found
