# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of the objects below a Design."""

from __future__ import annotations

from functools import lru_cache, partial
from typing import Any

import FreeCADGui
from pivy import coin

from ...features import status
from ...features.proxy import design_of
from .. import commands
from ..notice import errors_shown
from ..panel import show
from ..qt import RESOURCES, QtCore, QtGui
from ..solve import SolvePanel

_SIZE = 64
# Drawn in a square of 1: polylines, closed and filled on a disc of the colour.
_BADGES = {
    status.OUT_OF_DATE: ("#e08a00", (((0.5, 0.22), (0.5, 0.52)), ((0.5, 0.52), (0.72, 0.64)))),  # a clock
    status.INVALID: ("#c62828", (((0.3, 0.3), (0.7, 0.7)), ((0.3, 0.7), (0.7, 0.3)))),  # a cross
    status.RUNNING: ("#1565c0", (((0.38, 0.26), (0.74, 0.5), (0.38, 0.74), (0.38, 0.26)),)),  # play
    status.EMPTY: ("#757575", (((0.28, 0.5), (0.72, 0.5)),)),  # a dash
}


class View:
    """Icon with a badge of the object's state. FreeCAD stores the class, and attaches it on opening."""

    ICON = "CurveUpsWorkbench"
    MENU: tuple[str, ...] = ()  # commands
    GROUP = ""  # of the parameters that the panel shows after a double click

    def __init__(self, view: Any):
        self.object = view.Object
        view.Proxy = self

    def doubleClicked(self, view: Any) -> bool:
        """Opens the design's panel."""
        design = design_of(self.object)
        if design is not None:
            with errors_shown(""):
                show(SolvePanel, design).turn_to(self.GROUP)
        return design is not None

    def setupContextMenu(self, view: Any, menu: Any) -> None:
        for name in self.MENU:
            if known(name):
                command = FreeCADGui.Command.get(name)
                action = menu.addAction(command.getInfo()["menuText"].replace("&", ""))
                action.setEnabled(command.isActive())
                action.triggered.connect(partial(run_on, self.object, name))

    def attach(self, view: Any) -> None:
        self.object = view.Object

    def updateData(self, obj: Any, name: str) -> None:
        if name == "Status":
            obj.ViewObject.signalChangeIcon()

    def getIcon(self) -> Any:
        return _icon(self.ICON, getattr(self.object, "Status", ""))

    def dumps(self) -> Any:
        return None

    def loads(self, state: Any) -> None:
        self.object = None

    __getstate__ = dumps
    __setstate__ = loads


def select(obj: Any) -> None:
    """Makes `obj` the selection: commands work on that."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name)


def known(command: str) -> bool:
    """Whether there is a command of ours; makes them known where the workbench was not active yet."""
    if command not in FreeCADGui.listCommands():
        commands.register()
    return command in FreeCADGui.listCommands()


def run_on(obj: Any, command: str, *_: Any) -> bool:
    """Runs a command of ours on what `obj` belongs to; whether there is one."""
    select(obj)
    if not known(command):
        return False
    FreeCADGui.runCommand(command)
    return True


@lru_cache(maxsize=None)
def _icon(name: str, state: str) -> Any:
    """The icon in resources/icons/`name`.svg with the badge of a state; current has none."""
    pixmap = QtGui.QIcon(str(RESOURCES / "icons" / f"{name}.svg")).pixmap(_SIZE, _SIZE)
    if state in _BADGES:
        painter = QtGui.QPainter(pixmap)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        _draw(painter, *_BADGES[state])
        painter.end()
    return QtGui.QIcon(pixmap)


def _draw(painter: Any, colour: str, lines: Any) -> None:
    size = 0.56 * _SIZE
    painter.translate(_SIZE - size, _SIZE - size)
    painter.setPen(QtGui.QPen(QtGui.QColor("white"), 3))
    painter.setBrush(QtGui.QColor(colour))
    painter.drawEllipse(QtCore.QRectF(2, 2, size - 4, size - 4))
    pen = QtGui.QPen(QtGui.QColor("white"), 5)
    pen.setCapStyle(QtCore.Qt.RoundCap)
    painter.setPen(pen)
    for line in lines:
        painter.drawPolyline(QtGui.QPolygonF([QtCore.QPointF(x * size, y * size) for x, y in line]))


class PartView(View):
    """Of an object without a shape: an empty display mode keeps it from being grey in the tree."""

    def attach(self, view: Any) -> None:
        super().attach(view)
        view.addDisplayMode(coin.SoGroup(), "Nothing")

    def getDisplayModes(self, view: Any) -> list[str]:
        return ["Nothing"]

    def getDefaultDisplayMode(self) -> str:
        return "Nothing"


class CutsView(PartView):
    """Of Cuts; a double click opens their own panel."""

    ICON = "CurveUps_Cuts"
    MENU = ("CurveUps_Cuts",)

    def doubleClicked(self, view: Any) -> bool:
        return run_on(self.object, "CurveUps_Cuts")


class LayoutView(PartView):
    """Of a Layout."""

    ICON = "CurveUps_ShowFlat"
    MENU = ("CurveUps_Solve", "CurveUps_Repair", "CurveUps_ShowFlat", "CurveUps_ShowActuated")
    GROUP = "Layout"


class VerificationView(PartView):
    """Of a Verification."""

    ICON = "CurveUps_Verify"
    MENU = ("CurveUps_Verify", "CurveUps_Repair", "CurveUps_WorstContacts", "CurveUps_Overlay")
    GROUP = "Physics"


_BUILT = ("CurveUps_BuildSolids", "CurveUps_ShowSolids", "CurveUps_Export")
# Icon, menu and group of parameters by kind of body; a target has none.
_SHAPES: dict[str, tuple[str, tuple[str, ...], str]] = {
    "": ("CurveUps_Target", ("CurveUps_Target", "CurveUps_Check", "CurveUps_Cuts", "CurveUps_Solve"),
         "Target"),
    "tiles": ("CurveUps_Tiles", _BUILT, "Tiles"),
    "support": ("CurveUps_Support", _BUILT, "Support"),
    "anchors": ("CurveUps_Anchors", _BUILT, "Anchors")}


class ShapeView(View):
    """View of Target, Tiles, Support and Anchors, which FreeCAD draws by itself."""

    def attach(self, view: Any) -> None:
        super().attach(view)
        self.ICON, self.MENU, self.GROUP = _SHAPES[getattr(view.Object, "Kind", "")]
