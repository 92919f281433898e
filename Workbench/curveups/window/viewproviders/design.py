# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object in the tree and in the 3D view."""

from __future__ import annotations

from typing import Any

from ...base.errors import tile_name
from ...features.proxy import SLOTS, type_of
from .. import overlays
from ..overlay import watching
from ..overlay.overlay import Overlay
from . import following
from .part import CutsView, LayoutView, ShapeView, VerificationView, View


class DesignView(View):
    """Icon of a Design, and what is below it; the overlay, its display, hangs on it. FreeCAD's selection
    knows tiles by their names, T00001 and so on."""

    overlay: Any = None

    MENU = ("CurveUps_Solve", "CurveUps_Verify", "CurveUps_Repair", "CurveUps_Actuate",
            "CurveUps_BuildSolids", "CurveUps_ShowFlat", "CurveUps_ShowActuated", "CurveUps_ShowSolids",
            "CurveUps_Export", "CurveUps_Report")

    def attach(self, view: Any) -> None:
        super().attach(view)
        watching.start()
        self.overlay = Overlay(view)
        overlays.add(view.Object, self.overlay)
        view.addDisplayMode(self.overlay.node, "Tiles")
        self.overlay.refresh()

    def updateData(self, obj: Any, name: str) -> None:
        super().updateData(obj, name)
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

    def setEdit(self, view: Any, mode: int = 0) -> bool:
        """Opens the panel; FreeCAD has no need of an edit mode."""
        self.doubleClicked(view)
        return False

    def claimChildren(self) -> list:
        return [part for slot in SLOTS if (part := getattr(self.object, slot, None)) is not None]

    def onDelete(self, view: Any, names: Any) -> bool:
        """Takes along what is below it, unless something else is made from that."""
        obj = view.Object
        for part in self.claimChildren():
            # A group, or a sheet that reads it, may lose what it links to.
            if all(other == obj or other.hasExtension("App::GroupExtension")
                   or other.TypeId == "Spreadsheet::Sheet" for other in part.InList):
                obj.Document.removeObject(part.Name)
        return True


_KINDS = {"CurveUps::Design": DesignView, "CurveUps::Cuts": CutsView, "CurveUps::Layout": LayoutView,
          "CurveUps::Verification": VerificationView, "CurveUps::Target": ShapeView,
          "CurveUps::Bodies": ShapeView}


def attach(obj: Any) -> None:
    """Gives an object of ours its view, where it has a Python one and lacks it."""
    following.install()
    view, kind = getattr(obj, "ViewObject", None), _KINDS.get(type_of(obj))
    if view is None or kind is None or "Proxy" not in view.PropertiesList:
        return
    if isinstance(view.Proxy, kind):
        return
    attached = view.Proxy is not None  # in a FreeCAD without this workbench; FreeCAD attaches a view once
    kind(view)
    if attached:
        view.Proxy.attach(view)
    if attached and kind is not ShapeView:
        view.DisplayMode = view.Proxy.getDisplayModes(view)
        view.Visibility = False
        view.Visibility = True
