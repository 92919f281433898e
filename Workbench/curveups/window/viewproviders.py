# SPDX-License-Identifier: LGPL-2.1-or-later
"""Views of a Design and of the objects below it, in the tree and in the 3D view."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import FreeCADGui
from pivy import coin

from ..base.errors import tile_name
from ..features import status
from ..features.proxy import SLOTS, design_of, type_of
from . import commands, overlays
from .notice import errors_shown
from .overlay.overlay import Overlay
from .panel import show
from .solve import SolvePanel
from .qt import RESOURCES, QtCore, QtGui
from .run import LIVE

_SIZE = 64  # px
# Colour and sign of a badge by state.
_BADGES = {status.OUT_OF_DATE: ("#e08a00", "!"), status.INVALID: ("#c62828", "×"),
           status.RUNNING: ("#1565c0", "▸"), status.EMPTY: ("#757575", "–")}


@lru_cache(maxsize=None)
def _icon(name: str, state: str) -> Any:
    """Icon in resources/icons/`name`.svg with the badge of a state; current has none."""
    pixmap = QtGui.QIcon(str(RESOURCES / "icons" / f"{name}.svg")).pixmap(_SIZE, _SIZE)
    if state in _BADGES:
        painter = QtGui.QPainter(pixmap)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        _draw(painter, *_BADGES[state])
        painter.end()
    return QtGui.QIcon(pixmap)


def _draw(painter: Any, colour: str, sign: str) -> None:
    """Draw a badge, a sign on a disc, in the lower right corner."""
    place = QtCore.QRectF(0.45 * _SIZE, 0.45 * _SIZE, 0.52 * _SIZE, 0.52 * _SIZE)
    painter.setPen(QtGui.QPen(QtGui.QColor("white"), 3))
    painter.setBrush(QtGui.QColor(colour))
    painter.drawEllipse(place)
    font = painter.font()
    font.setPixelSize(int(0.5 * _SIZE))
    font.setBold(True)
    painter.setFont(font)
    painter.drawText(place, QtCore.Qt.AlignCenter, sign)


def _known(command: str) -> bool:
    """True for a command of ours. Registers them where the workbench was not active yet."""
    if command not in FreeCADGui.listCommands():
        commands.register()
    return command in FreeCADGui.listCommands()


def _run_on(obj: Any, command: str, *_: Any) -> bool:
    """Select `obj` and run a command of ours on it; False where there is none."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name)
    if not _known(command):
        return False
    FreeCADGui.runCommand(command)
    return True


@dataclass(frozen=True)
class Look:
    """icon: in resources/icons. menu: commands. group: of the parameters that a double click shows."""

    icon: str
    menu: tuple[str, ...]
    group: str = ""


_BUILT = ("CurveUps_BuildSolids", "CurveUps_ShowSolids", "CurveUps_Export")
_LOOKS = {  # by type of object and kind of body
    ("CurveUps::Design", ""): Look("CurveUpsWorkbench", (
        "CurveUps_Solve", "CurveUps_Verify", "CurveUps_Repair", "CurveUps_Actuate", "CurveUps_BuildSolids",
        "CurveUps_ShowFlat", "CurveUps_ShowActuated", "CurveUps_ShowSolids", "CurveUps_Export",
        "CurveUps_Report")),
    ("CurveUps::Target", ""): Look("CurveUps_Target", (
        "CurveUps_Target", "CurveUps_Check", "CurveUps_Cuts", "CurveUps_Solve"), "Target"),
    ("CurveUps::Cuts", ""): Look("CurveUps_Cuts", ("CurveUps_Cuts",)),
    ("CurveUps::Layout", ""): Look("CurveUps_ShowFlat", (
        "CurveUps_Solve", "CurveUps_Repair", "CurveUps_ShowFlat", "CurveUps_ShowActuated"), "Layout"),
    ("CurveUps::Verification", ""): Look("CurveUps_Verify", (
        "CurveUps_Verify", "CurveUps_Repair", "CurveUps_WorstContacts", "CurveUps_Overlay"), "Physics"),
    ("CurveUps::Bodies", "tiles"): Look("CurveUps_Tiles", _BUILT, "Tiles"),
    ("CurveUps::Bodies", "support"): Look("CurveUps_Support", _BUILT, "Support"),
    ("CurveUps::Bodies", "anchors"): Look("CurveUps_Anchors", _BUILT, "Anchors")}


class View:
    """Icon with a badge of the object's state, context menu and double click. FreeCAD stores the class, and
    attaches it on opening."""

    def __init__(self, view: Any):
        self.object = view.Object
        view.Proxy = self

    def doubleClicked(self, view: Any) -> bool:
        """Open the design's panel."""
        design = design_of(self.object)
        if design is not None:
            with errors_shown(""):
                show(SolvePanel, design).turn_to(self._look().group)
        return design is not None

    def setupContextMenu(self, view: Any, menu: Any) -> None:
        for name in filter(_known, self._look().menu):
            command = FreeCADGui.Command.get(name)
            action = menu.addAction(command.getInfo()["menuText"].replace("&", ""))
            action.setEnabled(command.isActive())
            action.triggered.connect(partial(_run_on, self.object, name))

    def attach(self, view: Any) -> None:
        self.object = view.Object

    def _look(self) -> Look:
        kind = getattr(self.object, "CurveUpsType", ""), getattr(self.object, "Kind", "")
        return _LOOKS.get(kind, _LOOKS["CurveUps::Design", ""])  # while FreeCAD restores the object

    def updateData(self, obj: Any, name: str) -> None:
        if name == "Status":
            obj.ViewObject.signalChangeIcon()

    def getIcon(self) -> Any:
        return _icon(self._look().icon, getattr(self.object, "Status", ""))

    def dumps(self) -> Any:
        return None

    def loads(self, state: Any) -> None:
        self.object = None

    __getstate__ = dumps
    __setstate__ = loads


class ShapeView(View):
    """View of Target, Tiles, Support and Anchors, which FreeCAD draws by itself."""


class PartView(View):
    """View of an object without a shape. Its one display mode keeps it from being grey in the tree."""

    MODE = "Nothing"

    def attach(self, view: Any) -> None:
        super().attach(view)
        view.addDisplayMode(self.node(view), self.MODE)

    def node(self, view: Any) -> Any:
        return coin.SoGroup()

    def getDisplayModes(self, view: Any) -> list[str]:
        return [self.MODE]

    def getDefaultDisplayMode(self) -> str:
        return self.MODE


class CutsView(PartView):
    """View of Cuts; a double click opens their own panel."""

    def doubleClicked(self, view: Any) -> bool:
        return _run_on(self.object, "CurveUps_Cuts")


class DesignView(PartView):
    """View of a Design: the overlay, and the objects below it. FreeCAD's selection names tiles T00001 and so
    on."""

    MODE = "Tiles"
    overlay: Any = None

    def node(self, view: Any) -> Any:
        overlays.start()
        self.overlay = Overlay(view)
        overlays.add(view.Object, self.overlay)
        self.overlay.refresh()
        return self.overlay.node

    def updateData(self, obj: Any, name: str) -> None:
        super().updateData(obj, name)
        if self.overlay is not None:
            self.overlay.data_changed(name)

    def onChanged(self, view: Any, name: str) -> None:
        if self.overlay is not None:
            self.overlay.view_changed(name)

    def setDisplayMode(self, mode: str) -> str:
        return self.MODE

    def useNewSelectionModel(self) -> bool:
        return True

    def getElementPicked(self, picked: Any) -> str:
        tile = self.overlay.tile_of(picked) if self.overlay is not None else -1
        return tile_name(tile) if tile >= 0 else ""

    def setEdit(self, view: Any, mode: int = 0) -> bool:
        """Open the panel; there is no edit mode."""
        self.doubleClicked(view)
        return False

    def claimChildren(self) -> list:
        return [part for slot in SLOTS if (part := getattr(self.object, slot, None)) is not None]

    def onDelete(self, view: Any, names: Any) -> bool:
        """Delete the objects below it too, but for those that others are made from."""
        obj = view.Object
        for part in self.claimChildren():
            # A group, or a sheet that reads it, may lose what it links to.
            if all(other == obj or other.hasExtension("App::GroupExtension")
                   or other.TypeId == "Spreadsheet::Sheet" for other in part.InList):
                obj.Document.removeObject(part.Name)
        return True


_KINDS = {"CurveUps::Design": DesignView, "CurveUps::Cuts": CutsView, "CurveUps::Layout": PartView,
          "CurveUps::Verification": PartView, "CurveUps::Target": ShapeView,
          "CurveUps::Bodies": ShapeView}


def attach(obj: Any) -> None:
    """Give an object of ours its view, where it lacks it."""
    LIVE.install()
    view, kind = getattr(obj, "ViewObject", None), _KINDS.get(type_of(obj))
    if view is None or kind is None or "Proxy" not in view.PropertiesList or isinstance(view.Proxy, kind):
        return
    attached = view.Proxy is not None  # in a FreeCAD without this workbench; FreeCAD attaches a view once
    kind(view)
    if attached:
        view.Proxy.attach(view)
        if kind is not ShapeView:
            view.DisplayMode = view.Proxy.getDisplayModes(view)
            view.Visibility = False
            view.Visibility = True
