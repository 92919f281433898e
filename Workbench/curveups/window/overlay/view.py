# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a Design's view provider that shows the overlay, and tells FreeCAD what a click is on."""

from __future__ import annotations

from typing import Any

from ...base.errors import tile_name
from .. import overlays
from . import watching
from .overlay import Overlay


class OverlayView:
    """Base of a view provider: FreeCAD's selection knows tiles by their names, T00001 and so on."""

    overlay: Any = None

    def attach(self, view: Any) -> None:
        watching.start()
        self.overlay = Overlay(view)
        overlays.add(view.Object, self.overlay)
        view.addDisplayMode(self.overlay.node, "Tiles")
        self.overlay.refresh()

    def updateData(self, obj: Any, name: str) -> None:
        if self.overlay is not None:
            self.overlay.data_changed(name)

    def onChanged(self, view: Any, name: str) -> None:
        if self.overlay is not None:
            self.overlay.view_changed(name)

    def getDisplayModes(self, view: Any) -> list[str]:
        return ["Tiles"]

    def getDefaultDisplayMode(self) -> str:
        return "Tiles"

    def setDisplayMode(self, mode: str) -> str:
        return "Tiles"

    def useNewSelectionModel(self) -> bool:
        return True

    def getElementPicked(self, picked: Any) -> str:
        tile = self.overlay.tile_of(picked) if self.overlay is not None else -1
        return tile_name(tile) if tile >= 0 else ""
