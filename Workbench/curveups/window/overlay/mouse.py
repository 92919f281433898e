# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mouse and keys in the 3D views of a document, before FreeCAD sees them.

A view keeps one event filter from its beginning. Qt counts through a widget's filters: a command of the
view's context menu that installed another one would make FreeCAD see the click again that opened the menu,
and the menu would come back.
"""

from __future__ import annotations

from typing import Any, Callable

from ..qt import EventFilter
from .cameras import views_of

Handler = Callable[["Mouse", Any], bool]  # gets events; True keeps one from FreeCAD
_handlers: dict[str, list[Handler]] = {}  # by names of documents, the newest first
_mice: list["Mouse"] = []


def take(document: str, handler: Handler) -> None:
    """Lets a handler see the events of a document's views, before earlier ones."""
    known = _handlers.setdefault(document, [])
    if handler not in known:
        known.insert(0, handler)


def leave(document: str, handler: Handler) -> None:
    """The handler sees no more events."""
    if handler in _handlers.get(document, ()):
        _handlers[document].remove(handler)


def watch(document: str) -> None:
    """Gives views that have come since their filter."""
    _mice[:] = [one for one in _mice if one.alive()]
    for view in views_of(document):
        if not any(one.widget is view.graphicsView().viewport() for one in _mice):
            _mice.append(Mouse(view, document))


class Mouse(EventFilter):
    """Of one view."""

    def __init__(self, view: Any, document: str):
        self.view, self.widget = view, view.graphicsView().viewport()
        self._document = document
        super().__init__(self.widget, self.widget, view.graphicsView())  # keys go to the latter

    def alive(self) -> bool:
        """Whether its view is there still."""
        try:
            self.widget.width()
            return True
        except RuntimeError:
            return False

    def position(self, event: Any) -> tuple[float, float]:
        """In pixels of the screen from the view's lower left corner."""
        place = event.position() if hasattr(event, "position") else event.pos()
        ratio = self.widget.devicePixelRatioF()
        return place.x() * ratio, (self.widget.height() - 1 - place.y()) * ratio

    def takes(self, event: Any) -> bool:
        return any(handler(self, event) for handler in list(_handlers.get(self._document, ())))
