# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: a bar of colours, and the meaning of marks. Qt paints it and Coin shows the
image, so that saved pictures have it too."""

from __future__ import annotations

from dataclasses import dataclass
from textwrap import wrap
from typing import Any, Mapping, Optional

import FreeCADGui
import numpy as np
from pivy import coin

from ..qt import QtCore, QtGui, ink_and_paper
from ..units import short, user_unit
from . import colours
from .picture import add, separator, unpickable

LEFT, WIDTH, HEIGHT = 30, 16, 230   # of the bar, px
BEYOND = 0.12                       # share of the bar that lies beyond either end of the range
_MARGIN = 16                        # of the paper, left of the bar, px
_SIZE, _LINE = 13, 18               # height of letters, and of a line, px
_LETTERS, _STEPS = 30, 48           # letters a line, colours of the bar
_SIGNS = {"cross": "✕", "triangle": "▲", "square": "■", "diamond": "◇"}  # by mark


@dataclass(frozen=True)
class Content:
    """Texts and range of a legend. `marks`: shape and text. `notes`: lines about the values. `faded`: as the
    tiles are."""

    title: str
    unit: str = ""
    colour_map: str = ""
    low: float = 0.0
    high: float = 1.0
    has_bar: bool = True
    faded: bool = False
    notes: tuple[str, ...] = ()
    marks: tuple[tuple[str, str], ...] = ()

    @property
    def title_line(self) -> str:
        """Title with the unit that the user sees."""
        unit = user_unit(self.unit, max(abs(self.low), abs(self.high)))[1]
        return f"{self.title} ({unit})" if unit and self.has_bar else self.title

    def lines(self) -> list[tuple[str, str]]:
        """Lines of text below the bar, with the mark before each."""
        texts = (*(("", note) for note in self.notes), *self.marks)
        return [("" if row else mark, line) for mark, text in texts
                for row, line in enumerate(wrap(text, _LETTERS))]


class Legend:
    """A legend, drawn by `node`, which goes below the nodes of what it explains."""

    def __init__(self) -> None:
        self.content: Optional[Content] = None
        self.left, self.width = float(LEFT), 0.0  # of the bar, and of the whole, px
        self.heading = ""  # name of the design, if there are several
        camera, guard, drawn, self._image = (
            coin.SoOrthographicCamera(), coin.SoCallback(), coin.SoAnnotation(), coin.SoImage())
        # The image begins at the left edge of the view, half-way up.
        camera.viewportMapping, camera.height = coin.SoCamera.LEAVE_ALONE, 2.0
        camera.position, camera.nearDistance, camera.farDistance = (1.0, 0.0, 5.0), 0.0, 10.0
        self._image.vertAlignment = coin.SoImage.HALF
        guard.setCallback(self._guard)
        add(drawn, unpickable(), coin.SoResetTransform(), camera, self._image)
        # Not part of the scene's extent: "fit all" and clipping planes would count pixels as mm.
        self._only_drawn = coin.SoSwitch()
        self._only_drawn.addChild(drawn)
        group = separator(guard, self._only_drawn)
        group.renderCaching = group.boundingBoxCaching = coin.SoSeparator.OFF
        self.node = coin.SoSwitch()
        self.node.whichChild = coin.SO_SWITCH_NONE
        self.node.addChild(group)

    def _guard(self, data: Any, action: Any) -> None:
        """Show the legend to actions that draw, and to no others."""
        drawing = action.getTypeId().isDerivedFrom(coin.SoGLRenderAction.getClassTypeId())
        self._only_drawn.whichChild.enableNotify(False)
        self._only_drawn.whichChild = coin.SO_SWITCH_ALL if drawing else coin.SO_SWITCH_NONE
        self._only_drawn.whichChild.enableNotify(True)

    def put(self, left: float, heading: str) -> None:
        """Move it beside others. left: of the bar, px."""
        if (left, heading) != (self.left, self.heading):
            self.left, self.heading = left, heading
            self.show(self.content)

    def show(self, content: Optional[Content]) -> None:
        """Draw anew; None hides it."""
        self.content = content
        self.node.whichChild = coin.SO_SWITCH_NONE if content is None else coin.SO_SWITCH_ALL
        if content is not None:
            image = self._painted(content)
            rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
            size = coin.SbVec2s(image.width(), image.height())
            self._image.image.setValue(size, 4, rows[::-1].tobytes())  # Coin begins with the lowest row

    def _painted(self, content: Content) -> Any:
        """Image of the legend, transparent left of its paper."""
        ink, paper = ink_and_paper()
        paper = QtGui.QColor(paper)
        paper.setAlphaF(0.8)
        font, lines = QtGui.QFont(FreeCADGui.getMainWindow().font()), content.lines()
        font.setPixelSize(_SIZE)
        metrics = QtGui.QFontMetricsF(font)
        self.width = _MARGIN + 24 + max(metrics.horizontalAdvance(text) for text in (
            content.title_line, self.heading, "0" * 10, *(text for _, text in lines)))
        top = 2 * _LINE if self.heading else _LINE  # of the first line below the titles
        bar = HEIGHT + 18 if content.has_bar else 6
        height = top + bar + _LINE * len(lines) + 14
        image = QtGui.QImage(int(scale() * (self.left + self.width)), int(scale() * height),
                             QtGui.QImage.Format_RGBA8888)
        image.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.TextAntialiasing)
        painter.scale(scale(), scale())
        painter.fillRect(QtCore.QRectF(self.left - _MARGIN, 0, self.width, height), paper)
        painter.setFont(font)
        painter.setPen(ink)
        for row, text in enumerate(filter(None, (self.heading, content.title_line)), 1):
            painter.drawText(QtCore.QPointF(self.left - 8, _LINE * row), text)
        if content.has_bar:
            self._paint_bar(painter, content, top + 12)
        for row, (mark, text) in enumerate(lines, 1):
            base = top + bar + _LINE * row
            painter.drawText(QtCore.QPointF(self.left + (12 if mark else -8), base), text)
            if mark:
                painter.setPen(QtGui.QColor.fromRgbF(*colours.MARK))
                painter.drawText(QtCore.QPointF(self.left - 8, base), _SIGNS[mark])
                painter.setPen(ink)
        painter.end()
        return image

    def _paint_bar(self, painter: Any, content: Content, top: float) -> None:
        """Paint the bar, which begins at `top`, and its figures."""
        y = np.linspace(HEIGHT, 0, _STEPS + 1)[1:]  # upper ends of the steps, from the lowest on
        shares = (np.arange(_STEPS) + 0.5) / _STEPS * (1 + 2 * BEYOND) - BEYOND
        rgb = colours.sample(content.colour_map, shares)
        for above, colour in zip(y, colours.faded(rgb) if content.faded else rgb):
            painter.fillRect(QtCore.QRectF(self.left, top + above, WIDTH, HEIGHT / _STEPS + 0.5),
                             QtGui.QColor.fromRgbF(*map(float, colour)))
        factor, _ = user_unit(content.unit, max(abs(content.low), abs(content.high)))
        for share in np.linspace(0, 1, 5):
            value = content.low + share * (content.high - content.low)
            place = top + HEIGHT * (1 - (share + BEYOND) / (1 + 2 * BEYOND))
            end = QtCore.QPointF(self.left + WIDTH, place)
            painter.drawLine(end, end + QtCore.QPointF(4, 0))
            painter.drawText(end + QtCore.QPointF(8, 4), short(value * factor))


def arrange(legends: Mapping[str, Legend]) -> None:
    """Put legends that are shown in the same views, by names of their designs, side by side."""
    left: float = LEFT
    for name, legend in legends.items():
        legend.put(left, name[:_LETTERS] if len(legends) > 1 else "")
        left += legend.width + _MARGIN


def scale() -> float:
    """Pixels of the view to one of a usual screen: more on fine ones."""
    screen = FreeCADGui.getMainWindow().windowHandle().screen()
    return max(1.0, screen.devicePixelRatio() * screen.logicalDotsPerInchY() / 96)
