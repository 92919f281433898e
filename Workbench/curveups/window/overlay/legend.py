# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: a bar of colours, and what the marks mean. Coin draws it in the view's own
pixels, so that saved pictures have it too."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from textwrap import wrap
from typing import Any, Mapping, Optional, Sequence

import FreeCADGui
import numpy as np
from pivy import coin

from ..qt import ink_and_paper
from ..units import short, user_unit
from . import colours
from .nodes import Markers, add, fill, unlit, unpickable

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
        self._camera, self._place = coin.SoOrthographicCamera(), coin.SoTranslation()
        self._camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self._camera.nearDistance, self._camera.farDistance = 0.0, 10.0
        self._size = (0, 0)
        self.left, self.width = float(LEFT), 0.0  # of the bar, and of the whole, px
        self.heading = ""                # above the title, where there are several
        self._body = coin.SoSeparator()
        before, drawn = coin.SoCallback(), coin.SoAnnotation()
        before.setCallback(self._fit)
        add(drawn, unpickable(), coin.SoResetTransform(), before, self._camera, unlit(), self._place,
            self._body)
        # Not part of the scene's extent: or "fit all" and clipping planes would count pixels as mm.
        self._only_drawn = coin.SoSwitch()
        self._only_drawn.addChild(drawn)
        guard = coin.SoCallback()
        guard.setCallback(self._guard)
        group = coin.SoSeparator()
        group.renderCaching = group.boundingBoxCaching = coin.SoSeparator.OFF
        add(group, guard, self._only_drawn)
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
        y = np.linspace(0, HEIGHT, _STEPS + 1)
        middles = (y[:-1] + y[1:]) / 2
        shares = np.clip(middles / HEIGHT * (1 + 2 * BEYOND) - BEYOND, 0, 1)
        shown = colours.sample(content.colour_map, shares)
        for k, colour in enumerate(colours.faded(shown) if content.faded else shown):
            self._body.addChild(_polygon([(0, y[k]), (WIDTH, y[k]), (WIDTH, y[k + 1]), (0, y[k + 1])],
                                         colour))
        factor, _ = user_unit(content.unit, max(abs(content.low), abs(content.high)))
        for share in np.linspace(0, 1, 5):
            value = content.low + share * (content.high - content.low)
            place = HEIGHT * (share + BEYOND) / (1 + 2 * BEYOND)
            self._body.addChild(_polygon([(WIDTH, place - 0.5), (WIDTH + 4, place - 0.5),
                                          (WIDTH + 4, place + 0.5), (WIDTH, place + 0.5)], ink))
            self._write(short(value * factor), (WIDTH + 8, place - 4), ink)

    def _write(self, line: str, place: tuple[float, float], colour: Sequence[float]) -> None:
        group, base, shift, text = (coin.SoSeparator(), coin.SoBaseColor(), coin.SoTranslation(),
                                    coin.SoText2())
        base.rgb = tuple(colour)
        shift.translation = (*place, 0.2)
        text.string = line
        add(group, base, shift, text)
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
        add(scene, camera, font, text)
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
    add(group, material, points, face)
    return group
