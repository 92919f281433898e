# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the progress of a run as curves over its steps: energy, violation of constraints, contacts that are
weak."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence

from ..qt import QtCore, QtGui, QtWidgets, translate
from ..units import text_of

# Told apart in print and by eyes that see no red or green (Okabe and Ito), on light and dark grounds.
_ENERGY, _VIOLATION, _WEAK = "#0072B2", "#D55E00", "#009E73"
_DARK = {"#0072B2": "#56B4E9"}


class Curves(QtWidgets.QLabel):
    """Each curve has its own logarithmic scale: its shape tells, and its last value is written beside it.
    A label: what is behind and the colour of its text are those of the theme, a style sheet's too."""

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setMinimumHeight(110)
        self._curves: list[tuple[str, str, str, Sequence[float]]] = []  # name, unit, colour, values

    def show_status(self, status: Any) -> None:
        """Takes the figures of a worker's status."""
        curves = [(translate("CurveUpsCurves", "Energy"), "", _ENERGY, status.energies),
                  (translate("CurveUpsCurves", "Violation"), "mm", _VIOLATION, status.violations),
                  (translate("CurveUpsCurves", "Weak points"), "", _WEAK, status.weak_points)]
        known, self._curves = self._curves, [curve for curve in curves if len(curve[-1])]
        if self._curves != known:
            self.update()

    def paintEvent(self, event: Any) -> None:
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        ink = self.palette().color(self.foregroundRole())
        dark = ink.lightness() > 128  # light on a dark ground
        faint = QtGui.QColor(ink)
        faint.setAlpha(110)
        painter.setPen(faint)
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        line_height = painter.fontMetrics().height()
        plot = QtCore.QRectF(self.rect()).adjusted(8, 8 + line_height * len(self._curves), -8, -8)
        for number, (name, unit, colour, values) in enumerate(self._curves):
            shade = QtGui.QColor(_DARK.get(colour, colour) if dark else colour)
            painter.setPen(QtGui.QPen(shade, 2))
            last = text_of(values[-1], unit, values[-1])
            painter.drawText(8, 4 + line_height * (number + 1), f"{name}: {last}")
            path = _path(values, plot)
            if path is not None:
                painter.drawPath(path)
        if not self._curves:
            painter.setPen(faint)
            painter.drawText(self.rect(), QtCore.Qt.AlignCenter | QtCore.Qt.TextWordWrap,
                             translate("CurveUpsCurves", "Energy and violation appear here"))
        painter.end()


def _path(values: Sequence[float], plot: Any) -> Optional[Any]:
    """The curve within `plot`; None where there is nothing to draw. Zeros stand at the lower edge."""
    positive = [value for value in values if value > 0 and math.isfinite(value)]
    if not positive or plot.height() < 4:
        return None
    low, high = math.log(min(positive)), math.log(max(positive))
    span = max(high - low, 1e-3)
    # More points than pixels show nothing more.
    every = max(1, len(values) // max(1, int(plot.width())))
    shown = list(enumerate(values))[::every]
    path = QtGui.QPainterPath()
    for step, value in shown:
        x = plot.left() + plot.width() * step / max(1, len(values) - 1)
        share = (math.log(value) - low) / span if value > 0 and math.isfinite(value) else 0.0
        point = QtCore.QPointF(x, plot.bottom() - plot.height() * share)
        path.lineTo(point) if path.elementCount() else path.moveTo(point)
    return path
