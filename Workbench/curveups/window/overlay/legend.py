# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: a bar of colours whose ends can be dragged, and what the marks mean.

It is drawn in the view's own pixels by Coin, so that saved pictures have it too; `Dragging`
takes the mouse before the view does, so that neither camera nor selection notice.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from textwrap import wrap
from typing import Any, Callable, Mapping, Optional, Sequence

import FreeCADGui
import numpy as np
from pivy import coin

from ..qt import QtCore, ink_and_paper
from ..units import short, user_unit
from . import colours
from .mouse import Mouse
from .nodes import Markers, fill, unlit, unpickable

LEFT, WIDTH, HEIGHT = 30, 16, 230   # of the bar, px
BEYOND = 0.12                       # share of the bar that lies beyond either end of the range
_MARGIN = 16                        # of the paper, left of the bar, px
_SIZE, _LINE = 13, 18               # height of letters, and of a line, px
_VIEW = 1000                        # that a text is measured in, px
_MOST, _STEPS = 30, 48              # letters a line, colours of the bar


@dataclass(frozen=True)
class Content:
    """What a legend says. `marks`: shape of the mark, text. `notes`: lines about the values. Without a
    range there is no bar. `faded`: as the tiles are."""

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


class Legend:
    """Nodes of a legend. `node` goes below the nodes of what it explains."""

    def __init__(self) -> None:
        self.node = coin.SoSwitch()
        self.node.whichChild = coin.SO_SWITCH_NONE
        self.content: Optional[Content] = None
        self.axis: Optional[tuple[float, float]] = None  # what the bar spans while an end is dragged
        self._camera, self._place = coin.SoOrthographicCamera(), coin.SoTranslation()
        self._camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self._camera.nearDistance, self._camera.farDistance = 0.0, 10.0
        self._size = (0, 0)
        self.left, self.width = float(LEFT), 0.0  # of the bar, and of the whole, px
        self.heading = ""                # above the title, where there are several
        self._body = coin.SoSeparator()
        before, drawn = coin.SoCallback(), coin.SoAnnotation()
        before.setCallback(self._fit)
        for part in (unpickable(), coin.SoResetTransform(), before, self._camera, unlit(), self._place,
                     self._body):
            drawn.addChild(part)
        # Not part of the scene's extent: or "fit all" and clipping planes would count pixels as mm.
        self._only_drawn = coin.SoSwitch()
        self._only_drawn.addChild(drawn)
        guard = coin.SoCallback()
        guard.setCallback(self._guard)
        group = coin.SoSeparator()
        group.renderCaching = group.boundingBoxCaching = coin.SoSeparator.OFF
        group.addChild(guard)
        group.addChild(self._only_drawn)
        self.node.addChild(group)

    def _guard(self, data: Any, action: Any) -> None:
        """Opens the way for drawing alone."""
        draws = action.getTypeId().isDerivedFrom(coin.SoGLRenderAction.getClassTypeId())
        self._only_drawn.whichChild.enableNotify(False)
        self._only_drawn.whichChild = coin.SO_SWITCH_ALL if draws else coin.SO_SWITCH_NONE
        self._only_drawn.whichChild.enableNotify(True)

    def _fit(self, data: Any, action: Any) -> None:
        """A unit is a pixel of a usual screen; the bar stands at the left, half-way up."""
        if not action.getTypeId().isDerivedFrom(coin.SoGLRenderAction.getClassTypeId()):
            return
        width, height = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels()
        if (width, height) == self._size or not height:
            return
        self._size = (width, height)
        width, height = width / scale(), height / scale()
        camera, place = self._camera, self._place
        for field in (camera.position, camera.height, camera.aspectRatio, place.translation):
            field.enableNotify(False)
        camera.position = (width / 2, height / 2, 5)
        camera.height, camera.aspectRatio = height, width / height
        place.translation = (self.left, bottom(height), 0)
        for field in (camera.position, camera.height, camera.aspectRatio, place.translation):
            field.enableNotify(True)

    def put(self, left: float, heading: str) -> None:
        """Moves it beside others; left: of the bar, px. heading: tells it from them."""
        if heading != self.heading:
            self.heading = heading
            self.show(self.content)
        if left != self.left:
            self.left, self._size = left, (0, 0)
            self.node.touch()

    def show(self, content: Optional[Content]) -> None:
        """Draws anew; None hides it."""
        self.content = content
        self.node.whichChild = coin.SO_SWITCH_NONE if content is None else coin.SO_SWITCH_ALL
        self._body.removeAllChildren()
        if content is None:
            return
        ink, paper = (colour.getRgbF()[:3] for colour in ink_and_paper())
        lines = _lines(content)
        longest = max([len(line) for _, line in lines] + [len(self.heading), 10])
        wide = longest * _letter(_SIZE * scale()) / scale() + 24
        self.width = wide + _MARGIN
        low = -_LINE * (len(lines) - 1) - 14
        title = HEIGHT + 16 if content.has_bar else 6
        top = title + 20 + (_LINE if self.heading else 0)
        corners = [(-_MARGIN, low), (wide, low), (wide, top), (-_MARGIN, top)]
        self._body.addChild(_polygon(corners, paper, 0.2))
        font = coin.SoFont()
        font.size = _SIZE * scale()
        self._body.addChild(font)
        self._write(content.title_line, (-8, title), ink)
        if self.heading:
            self._write(self.heading, (-8, title + _LINE), ink)
        if content.has_bar:
            self._draw_bar(content, ink)
        for row, (mark, line) in enumerate(lines[1:]):
            y = -_LINE * (row + 1)
            if mark:
                marker = Markers(mark, colours.MARK)
                marker.set_points(np.array([[-2, y + 4, 0.2]]))
                self._body.addChild(marker.node)
            self._write(line, (12 if mark else -8, y), ink)

    def _draw_bar(self, content: Content, ink: tuple) -> None:
        first, last = self.axis or (content.low, content.high)

        def share_of(value: float) -> float:
            return (value - first) / (last - first)

        y = np.linspace(0, HEIGHT, _STEPS + 1)
        values = np.array([first + share_at(middle) * (last - first) for middle in (y[:-1] + y[1:]) / 2])
        shown = colours.sample(content.colour_map, colours.shares(values, content.low, content.high))
        for k, colour in enumerate(colours.faded(shown) if content.faded else shown):
            self._body.addChild(_polygon([(0, y[k]), (WIDTH, y[k]), (WIDTH, y[k + 1]), (0, y[k + 1])],
                                         colour))
        factor, _ = user_unit(content.unit, max(abs(content.low), abs(content.high)))
        for value in np.linspace(content.low, content.high, 5):
            place = height_of(share_of(value))
            if value in (content.low, content.high):
                self._body.addChild(_polygon([(-10, place - 6), (0, place), (-10, place + 6)], ink))
            self._body.addChild(_polygon([(WIDTH, place - 0.5), (WIDTH + 4, place - 0.5),
                                          (WIDTH + 4, place + 0.5), (WIDTH, place + 0.5)], ink))
            self._write(short(value * factor), (WIDTH + 8, place - 4), ink)

    def _write(self, line: str, place: tuple[float, float], colour: Sequence[float]) -> None:
        group, base, shift, text = (coin.SoSeparator(), coin.SoBaseColor(), coin.SoTranslation(),
                                    coin.SoText2())
        base.rgb = tuple(colour)
        shift.translation = (*place, 0.2)
        text.string = line
        for part in (base, shift, text):
            group.addChild(part)
        self._body.addChild(group)


def arrange(legends: Mapping[str, Legend]) -> None:
    """Legends that are shown in the same views, by what they are of, stand side by side."""
    left: float = LEFT
    for name, one in legends.items():
        one.put(left, name[:_MOST] if len(legends) > 1 else "")
        left += one.width + _MARGIN


def scale() -> float:
    """Pixels of the view to one of a usual screen: more on fine ones."""
    screen = FreeCADGui.getMainWindow().windowHandle().screen()
    return max(1.0, screen.devicePixelRatio() * screen.logicalDotsPerInchY() / 96)


def bottom(height: float) -> float:
    """Where the bar begins, in px from the lower edge of a view of this height."""
    return max(60.0, (height - HEIGHT) / 2)


def height_of(share: float) -> float:
    """Where a share of the range is on the bar, px from its lower end."""
    return HEIGHT * (share + BEYOND) / (1 + 2 * BEYOND)


def share_at(y: float) -> float:
    """The inverse of `height_of`."""
    return y / HEIGHT * (1 + 2 * BEYOND) - BEYOND


def _lines(content: Content) -> list[tuple[str, str]]:
    """All lines of text with the mark before each."""
    found = [("", content.title_line)]
    for mark, line in (*(("", note) for note in content.notes), *content.marks):
        for piece in wrap(line, _MOST):
            found.append((mark, piece))
            mark = ""
    return found


@lru_cache(maxsize=None)
def _letter(size: float) -> float:
    """Width of a letter, pixels: Coin draws all with the same, in one of the few sizes that it has."""

    def width(letters: int) -> float:  # of a line, with something beside it
        scene, camera, font, text = (coin.SoSeparator(), coin.SoOrthographicCamera(), coin.SoFont(),
                                     coin.SoText2())
        camera.height, font.size, text.string = _VIEW, size, "0" * letters
        for part in (camera, font, text):
            scene.addChild(part)
        scene.ref()
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(_VIEW, _VIEW))
        action.apply(scene)
        scene.unref()
        return float(action.getBoundingBox().getSize()[0])

    return (width(20) - width(10)) / 10


def _polygon(corners: Sequence[tuple], colour: Sequence[float], transparency: float = 0.0) -> Any:
    group, material, points, face = (coin.SoSeparator(), coin.SoMaterial(), coin.SoCoordinate3(),
                                     coin.SoFaceSet())
    material.diffuseColor, material.transparency = tuple(float(x) for x in colour), transparency
    fill(points.point, np.array([(*corner, 0.0 if transparency else 0.1) for corner in corners]))
    face.numVertices = len(corners)
    for part in (material, points, face):
        group.addChild(part)
    return group


class Dragging:
    """Lets the mouse drag the ends of a legend's range: a handler of mouse.py."""

    def __init__(self, legend: Legend, visible: Callable[[], bool],
                 set_range: Callable[[Optional[tuple[float, float]]], None]):
        """set_range: gets the new range, or None for the automatic one."""
        self._legend, self._visible, self._set_range = legend, visible, set_range
        self._dragged: Optional[tuple[str, float, float]] = None  # which end, and the range at the start

    def taken(self, at: Mouse, event: Any) -> bool:
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove and self._dragged:
            self._move(at, event)
            return True
        if kind == QtCore.QEvent.MouseButtonRelease and self._dragged:
            self._dragged = self._legend.axis = None
            self._legend.show(self._legend.content)
            return True
        if kind not in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            return False
        content = self._legend.content
        if event.button() != QtCore.Qt.LeftButton or content is None or not content.has_bar \
                or not self._visible():
            return False
        x, y = self._position(at, event)
        if not (-14 <= x <= WIDTH + 60 and -8 <= y <= HEIGHT + 8):
            return False
        if kind == QtCore.QEvent.MouseButtonDblClick:
            self._set_range(None)
            return True
        self._dragged = ("low" if share_at(y) < 0.5 else "high", content.low, content.high)
        self._legend.axis = (content.low, content.high)
        return True

    def _move(self, at: Mouse, event: Any) -> None:
        assert self._dragged is not None
        end, low, high = self._dragged
        share = share_at(self._position(at, event)[1])
        value = low + share * (high - low)
        least = 0.02 * (high - low)
        self._set_range((min(value, high - least), high) if end == "low" else (low, max(value, low + least)))

    def _position(self, at: Mouse, event: Any) -> tuple[float, float]:
        """In px of the view from the bar's lower left corner."""
        x, y = (length / scale() for length in at.position(event))
        height = at.widget.height() * at.widget.devicePixelRatioF() / scale()
        return x - self._legend.left, y - bottom(height)
