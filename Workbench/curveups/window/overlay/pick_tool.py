# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse on a design's tiles and their edges, in all 3D views of its document, while a tool is at work."""

from __future__ import annotations

import time
from contextlib import suppress
from typing import Any, Callable, Optional

from ..qt import QtCore
from .cameras import views_of
from .picking import Pick, pick

_SECONDS_BETWEEN_LOOKS = 0.03


class PickTool:
    """hover: gets a Pick or None as the mouse moves. click: gets a Pick; beside the tiles, and to turn or
    move the view, the mouse stays FreeCAD's. escape: answers whether Escape was of use."""

    def __init__(self, design: Any, hover: Callable[[Optional[Pick]], None], click: Callable[[Pick], None],
                 escape: Callable[[], bool]):
        self._design = design
        self._hover, self._click, self._escape = hover, click, escape
        self._looked, self._pressed = 0.0, False
        self._filters = [_Filter(view, self._takes) for view in views_of(design.Document.Name)]

    def close(self) -> None:
        """The mouse is FreeCAD's again."""
        for one in self._filters:
            one.close()

    def _takes(self, view: Any, event: Any) -> bool:
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove and not event.buttons():
            now = time.perf_counter()
            if now - self._looked >= _SECONDS_BETWEEN_LOOKS:
                self._looked = now
                self._hover(self._find(view, event))
        elif kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            self._pressed = event.button() == QtCore.Qt.LeftButton and self._find(view, event) is not None
            return self._pressed
        elif kind == QtCore.QEvent.MouseButtonRelease and self._pressed:
            self._pressed = False
            found = self._find(view, event)
            if found is not None:
                self._click(found)
            return True
        elif kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            return self._escape()
        return False

    def _find(self, view: Any, event: Any) -> Optional[Pick]:
        """At the event's place, in pixels of the screen from the view's lower left corner."""
        area = view.graphicsView().viewport()
        place = event.position() if hasattr(event, "position") else event.pos()
        ratio = area.devicePixelRatioF()
        return pick(view, (place.x() * ratio, (area.height() - 1 - place.y()) * ratio), self._design)


class _Filter(QtCore.QObject):
    """Sees the events of a view before FreeCAD does. takes: whether FreeCAD does not get one."""

    def __init__(self, view: Any, takes: Callable[[Any, Any], bool]):
        super().__init__()
        self._view, self._takes = view, takes
        self._widgets = view.graphicsView().viewport(), view.graphicsView()  # mouse, keys
        for widget in self._widgets:
            widget.installEventFilter(self)

    def close(self) -> None:
        """Sees no more events."""
        with suppress(RuntimeError):  # the view is gone
            for widget in self._widgets:
                widget.removeEventFilter(self)

    def eventFilter(self, widget: Any, event: Any) -> bool:
        # PySide2 may hand over a deleted object that had the event's address.
        try:
            return isinstance(event, QtCore.QEvent) and self._takes(self._view, event)
        except (RuntimeError, ReferenceError):  # a view or a design is going
            return False
