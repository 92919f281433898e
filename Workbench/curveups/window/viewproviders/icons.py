# SPDX-License-Identifier: LGPL-2.1-or-later
"""Icons of the tree: what an object is, with a badge of its state that differs in shape as well."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from ...features import status
from ..qt import RESOURCES, QtCore, QtGui

SIZE = 64
# Drawn in a square of 1: polylines, closed and filled on a disc of the colour.
_BADGES = {
    status.OUT_OF_DATE: ("#e08a00", (((0.5, 0.22), (0.5, 0.52)), ((0.5, 0.52), (0.72, 0.64)))),  # a clock
    status.INVALID: ("#c62828", (((0.3, 0.3), (0.7, 0.7)), ((0.3, 0.7), (0.7, 0.3)))),  # a cross
    status.RUNNING: ("#1565c0", (((0.38, 0.26), (0.74, 0.5), (0.38, 0.74), (0.38, 0.26)),)),  # play
    status.EMPTY: ("#757575", (((0.28, 0.5), (0.72, 0.5)),)),  # a dash
}


@lru_cache(maxsize=None)
def icon(name: str, state: str) -> Any:
    """The icon in resources/icons/`name`.svg with the badge of a state; current has none."""
    pixmap = QtGui.QIcon(str(RESOURCES / "icons" / f"{name}.svg")).pixmap(SIZE, SIZE)
    if state in _BADGES:
        painter = QtGui.QPainter(pixmap)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        _draw(painter, *_BADGES[state])
        painter.end()
    return QtGui.QIcon(pixmap)


def _draw(painter: Any, colour: str, lines: Any) -> None:
    size = 0.56 * SIZE
    painter.translate(SIZE - size, SIZE - size)
    painter.setPen(QtGui.QPen(QtGui.QColor("white"), 3))
    painter.setBrush(QtGui.QColor(colour))
    painter.drawEllipse(QtCore.QRectF(2, 2, size - 4, size - 4))
    pen = QtGui.QPen(QtGui.QColor("white"), 5)
    pen.setCapStyle(QtCore.Qt.RoundCap)
    painter.setPen(pen)
    for line in lines:
        painter.drawPolyline(QtGui.QPolygonF([QtCore.QPointF(x * size, y * size) for x, y in line]))
