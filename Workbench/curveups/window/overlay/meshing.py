# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thousands of solids are triangulated a few at a time before they are shown: FreeCAD would do all of it at
once, without a word and without an end."""

from __future__ import annotations

import math
import time
from typing import Any, Callable

import FreeCADGui

from ..qt import QtCore, QtWidgets, translate

_AT_ONCE = 150   # solids that take no time worth speaking of
_SLICE = 0.04    # s of work between two looks at the mouse
_going: list["_Meshing"] = []  # one at most


def when_meshed(body: Any, then: Callable[[], None]) -> None:
    """Calls `then` once a Part object can be shown quickly; not at all if the user cancels meanwhile."""
    for other in list(_going):
        other.end()
    if len(body.Shape.Solids) <= _AT_ONCE:
        then()
    else:
        _going.append(_Meshing(body, then))


class _Meshing:
    """Triangulations stay with the shape: its view provider finds them there, if they are as fine as it
    wants them to be."""

    def __init__(self, body: Any, then: Callable[[], None]):
        view, box = body.ViewObject, body.Shape.BoundBox
        self._body, self._shape, self._then = body, body.Shape, then
        self._solids, self._next = self._shape.Solids, 0
        # As FreeCAD's own view of a shape has it.
        extent = box.XLength + box.YLength + box.ZLength
        self._fineness = {"LinearDeflection": extent / 300 * view.Deviation,
                          "AngularDeflection": math.radians(view.AngularDeflection)}
        self._dialog = QtWidgets.QProgressDialog(
            translate("CurveUps_ShowSolids", "Triangulating {count} solids", count=len(self._solids)),
            translate("CurveUps_ShowSolids", "Cancel"), 0, len(self._solids), FreeCADGui.getMainWindow())
        self._dialog.setObjectName("CurveUpsShowSolids")
        self._dialog.setWindowModality(QtCore.Qt.WindowModal)
        self._dialog.setMinimumDuration(300)
        self._dialog.canceled.connect(lambda: self.end())
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(lambda: self._step())
        self._timer.start(0)

    def _step(self) -> None:
        import MeshPart

        try:
            if not self._body.Shape.isPartner(self._shape):  # built anew: what is done here is of no use
                self.end()
                return
        except ReferenceError:  # deleted
            self.end()
            return
        until = time.perf_counter() + _SLICE
        while self._next < len(self._solids):
            MeshPart.meshFromShape(Shape=self._solids[self._next], **self._fineness)
            self._next += 1
            if time.perf_counter() > until:
                break
        if self._next == len(self._solids):
            self.end()
            self._then()
        elif self in _going:
            self._dialog.setValue(self._next)

    def end(self) -> None:
        """Leaves it as it is."""
        if self in _going:
            _going.remove(self)
            self._timer.stop()
            self._dialog.canceled.disconnect()
            self._dialog.close()
            self._dialog.deleteLater()
