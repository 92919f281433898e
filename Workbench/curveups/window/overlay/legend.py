# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: a bar of colours, and the meaning of marks. Coin draws it in the view's own
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
from .nodes import add, coloured, fill, markers, separator, unlit, unpickable

LEFT, WIDTH, HEIGHT = 30, 16, 230   # of the bar, px
BEYOND = 0.12                       # share of the bar that lies beyond either end of the range
_MARGIN = 16                        # of the paper, left of the bar, px
_SIZE, _LINE = 13, 18               # height of letters, and of a line, px
_VIEW = 1000                        # side of the view in which a text is measured, px
_LETTERS, _STEPS = 30, 48           # letters a line, colours of the bar


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
        lines = []
        for mark, text in (*(("", note) for note in self.notes), *self.marks):
            for piece in wrap(text, _LETTERS):
                lines.append((mark, piece))
                mark = ""
        return lines


class Legend:
    """A legend, drawn by `node`, which goes below the nodes of what it explains."""

    def __init__(self) -> None:
        self.content: Optional[Content] = None
        self.left, self.width = float(LEFT), 0.0  # of the bar, and of the whole, px
        self.heading = ""  # name of the design, if there are several
        self._size = (0, 0)  # of the view, px
        self._camera, self._place = coin.SoOrthographicCamera(), coin.SoTranslation()
        self._camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self._camera.nearDistance, self._camera.farDistance = 0.0, 10.0
        self._body = coin.SoSeparator()
        fit, guard, drawn = coin.SoCallback(), coin.SoCallback(), coin.SoAnnotation()
        fit.setCallback(self._fit)
        guard.setCallback(self._guard)
        add(drawn, unpickable(), coin.SoResetTransform(), fit, self._camera, unlit(), self._place, self._body)
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

    def _fit(self, data: Any, action: Any) -> None:
        """Make a unit a pixel of a usual screen, and put the bar at the left, half-way up."""
        if not action.getTypeId().isDerivedFrom(coin.SoGLRenderAction.getClassTypeId()):
            return
        width, height = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels()
        if (width, height) == self._size or not height:
            return
        self._size = (width, height)
        width, height = width / scale(), height / scale()
        camera, place = self._camera, self._place
        for field in (camera.position, camera.height, camera.aspectRatio, place.translation):
            field.enableNotify(False)  # the view is being drawn, and would be again
        camera.position = (width / 2, height / 2, 5)
        camera.height, camera.aspectRatio = height, width / height
        place.translation = (self.left, max(60.0, (height - HEIGHT) / 2), 0)
        for field in (camera.position, camera.height, camera.aspectRatio, place.translation):
            field.enableNotify(True)

    def put(self, left: float, heading: str) -> None:
        """Move it beside others. left: of the bar, px."""
        if heading != self.heading:
            self.heading = heading
            self.show(self.content)
        if left != self.left:
            self.left, self._size = left, (0, 0)
            self.node.touch()

    def show(self, content: Optional[Content]) -> None:
        """Draw anew; None hides it."""
        self.content = content
        self.node.whichChild = coin.SO_SWITCH_NONE if content is None else coin.SO_SWITCH_ALL
        self._body.removeAllChildren()
        if content is None:
            return
        ink, paper = (colour.getRgbF()[:3] for colour in ink_and_paper())
        lines = content.lines()
        letters = max(len(text) for text in (content.title_line, self.heading, "0" * 10,
                                             *(text for _, text in lines)))
        right = letters * _letter(_SIZE * scale()) / scale() + 24
        self.width = right + _MARGIN
        bottom = -_LINE * len(lines) - 14
        title = HEIGHT + 16 if content.has_bar else 6
        top = title + 20 + (_LINE if self.heading else 0)
        font = coin.SoFont()
        font.size = _SIZE * scale()
        add(self._body, _rectangle(-_MARGIN, bottom, right, top, paper, 0.2), font,
            _text(content.title_line, -8, title, ink), _text(self.heading, -8, title + _LINE, ink))
        if content.has_bar:
            self._draw_bar(content, ink)
        for row, (mark, text) in enumerate(lines, 1):
            if mark:
                self._body.addChild(markers(mark, colours.MARK, np.array([[-2, 4 - _LINE * row, 0.2]])))
            self._body.addChild(_text(text, 12 if mark else -8, -_LINE * row, ink))

    def _draw_bar(self, content: Content, ink: Sequence[float]) -> None:
        y = np.linspace(0, HEIGHT, _STEPS + 1)
        shares = np.clip((y[:-1] + y[1:]) / (2 * HEIGHT) * (1 + 2 * BEYOND) - BEYOND, 0, 1)
        rgb = colours.sample(content.colour_map, shares)
        for low, high, colour in zip(y, y[1:], colours.faded(rgb) if content.faded else rgb):
            self._body.addChild(_rectangle(0, low, WIDTH, high, colour))
        factor, _ = user_unit(content.unit, max(abs(content.low), abs(content.high)))
        for share in np.linspace(0, 1, 5):
            value = content.low + share * (content.high - content.low)
            place = HEIGHT * (share + BEYOND) / (1 + 2 * BEYOND)
            add(self._body, _rectangle(WIDTH, place - 0.5, WIDTH + 4, place + 0.5, ink),
                _text(short(value * factor), WIDTH + 8, place - 4, ink))


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


@lru_cache(maxsize=None)
def _letter(size: float) -> float:
    """Width of a letter, px: Coin draws all with the same, in one of the few sizes that it has."""

    def width(letters: int) -> float:  # of a line, with a margin
        camera, font, text = coin.SoOrthographicCamera(), coin.SoFont(), coin.SoText2()
        camera.height, font.size, text.string = _VIEW, size, "0" * letters
        scene = separator(camera, font, text)
        scene.ref()
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(_VIEW, _VIEW))
        action.apply(scene)
        scene.unref()
        return float(action.getBoundingBox().getSize()[0])

    return (width(20) - width(10)) / 10


def _text(text: str, x: float, y: float, rgb: Sequence[float]) -> Any:
    shift, line = coin.SoTranslation(), coin.SoText2()
    shift.translation = (x, y, 0.2)
    line.string = text
    return separator(coloured(rgb), shift, line)


def _rectangle(left: float, low: float, right: float, high: float, rgb: Sequence[float],
               transparency: float = 0.0) -> Any:
    material, points, face = coin.SoMaterial(), coin.SoCoordinate3(), coin.SoFaceSet()
    material.diffuseColor, material.transparency = tuple(float(x) for x in rgb), transparency
    depth = 0.0 if transparency else 0.1
    fill(points.point, np.array([(left, low, depth), (right, low, depth), (right, high, depth),
                                 (left, high, depth)]))
    face.numVertices = 4
    return separator(material, points, face)
