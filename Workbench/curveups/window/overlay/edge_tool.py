# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse on edges of a design's tiles, in all 3D views of its document, while a tool is at work."""

from __future__ import annotations

import time
from typing import Any, Callable, Optional

import FreeCADGui

from ..qt import EventFilter, QtCore
from .picking import Pick, pick

_SECONDS_BETWEEN_LOOKS = 0.03


class EdgeTool:
    """hover: gets a Pick or None as the mouse moves. click: gets a Pick; beside the tiles, and to turn or
    move the view, the mouse stays FreeCAD's. escape: answers whether Escape was of use."""

    def __init__(self, design: Any, hover: Callable[[Optional[Pick]], None], click: Callable[[Pick], None],
                 escape: Callable[[], bool]):
        document = FreeCADGui.getDocument(design.Document.Name)
        views = document.mdiViewsOfType("Gui::View3DInventor")
        self._filters = [_Filter(view, design, hover, click, escape) for view in views]

    def close(self) -> None:
        for one in self._filters:
            one.close()
        self._filters = []


class _Filter(EventFilter):
    """Sees the mouse of one view before FreeCAD does."""

    def __init__(self, view: Any, design: Any, hover: Callable, click: Callable, escape: Callable):
        self._widget = view.graphicsView().viewport()
        super().__init__(self._widget, self._widget, view.graphicsView())  # keys go to the latter
        self._view, self._design = view, design
        self._hover, self._click, self._escape = hover, click, escape
        self._looked, self._pressed = 0.0, False

    def close(self) -> None:
        try:
            for widget in (self._widget, self._view.graphicsView()):
                widget.removeEventFilter(self)
            self.deleteLater()
        except (RuntimeError, ReferenceError):  # the view was closed meanwhile
            pass

    def takes(self, event: Any) -> bool:
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove and not event.buttons():
            now = time.perf_counter()
            if now - self._looked >= _SECONDS_BETWEEN_LOOKS:
                self._looked = now
                self._hover(self._find(event))
        elif kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            self._pressed = event.button() == QtCore.Qt.LeftButton and self._find(event) is not None
            return self._pressed
        elif kind == QtCore.QEvent.MouseButtonRelease and self._pressed:
            self._pressed = False
            found = self._find(event)
            if found is not None:
                self._click(found)
            return True
        elif kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            return self._escape()
        return False

    def _find(self, event: Any) -> Optional[Pick]:
        place = event.position() if hasattr(event, "position") else event.pos()
        ratio = self._widget.devicePixelRatioF()
        return pick(self._view, (place.x() * ratio, (self._widget.height() - 1 - place.y()) * ratio),
                    self._design)
