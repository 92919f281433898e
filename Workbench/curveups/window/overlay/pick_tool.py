# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse on a design's tiles and their edges, in all 3D views of its document, while a tool is at work."""

from __future__ import annotations

import time
from typing import Any, Callable, Optional

from ..qt import QtCore
from . import mouse
from .picking import Pick, pick

_SECONDS_BETWEEN_LOOKS = 0.03


class PickTool:
    """hover: gets a Pick or None as the mouse moves. click: gets a Pick; beside the tiles, and to turn or
    move the view, the mouse stays FreeCAD's. escape: answers whether Escape was of use. paint: gets the
    Picks below the mouse while it is dragged with Shift, and None at the end."""

    def __init__(self, design: Any, hover: Callable[[Optional[Pick]], None], click: Callable[[Pick], None],
                 escape: Callable[[], bool], paint: Optional[Callable[[Optional[Pick]], None]] = None):
        self._design, self._document = design, design.Document.Name
        self._hover, self._click, self._escape, self._paint = hover, click, escape, paint
        self._looked, self._pressed, self._painting = 0.0, False, False
        mouse.take(self._document, self._taken)

    def close(self) -> None:
        mouse.leave(self._document, self._taken)

    def _taken(self, at: mouse.Mouse, event: Any) -> bool:
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove and self._painting:
            self._go_on(at, event)
            return True
        if kind == QtCore.QEvent.MouseMove and not event.buttons():
            now = time.perf_counter()
            if now - self._looked >= _SECONDS_BETWEEN_LOOKS:
                self._looked = now
                self._hover(self._find(at, event))
        elif kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            self._pressed = event.button() == QtCore.Qt.LeftButton and self._find(at, event) is not None
            self._painting = self._pressed and self._paint is not None and bool(
                event.modifiers() & QtCore.Qt.ShiftModifier)
            if self._painting:
                self._go_on(at, event)
            return self._pressed
        elif kind == QtCore.QEvent.MouseButtonRelease and self._pressed:
            painted, self._pressed, self._painting = self._painting, False, False
            found = self._find(at, event)
            if painted and self._paint is not None:
                self._paint(None)
            elif found is not None:
                self._click(found)
            return True
        elif kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            return self._escape()
        return False

    def _go_on(self, at: mouse.Mouse, event: Any) -> None:
        found = self._find(at, event)
        if found is not None and self._paint is not None:
            self._paint(found)

    def _find(self, at: mouse.Mouse, event: Any) -> Optional[Pick]:
        return pick(at.view, at.position(event), self._design)
