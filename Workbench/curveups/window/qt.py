# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only import of PySide. FreeCAD 0.20 has Qt 5 without a QtWidgets of PySide (widgets are in its
QtGui), later ones have Qt 5 or 6 with one."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ("EventFilter", "QtCore", "QtGui", "QtWidgets", "QT_TRANSLATE_NOOP", "ink_and_paper", "load_ui",
           "translate")

RESOURCES = Path(__file__).parents[3] / "resources"


def translate(context: str, text: str, **values: Any) -> str:
    """`text` in the user's language; `{name}` in it stands for values[name]."""
    found = QtCore.QCoreApplication.translate(context, text)
    return found.format(**values) if values else found


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Marks a text that FreeCAD or a later `translate` translates."""
    return text


@lru_cache(maxsize=None)
def _sample() -> Any:
    """A label that nobody sees. It stays: PySide would take later widgets at its address for it."""
    label = QtWidgets.QLabel(FreeCADGui.getMainWindow())
    label.hide()
    return label


def ink_and_paper() -> tuple[Any, Any]:
    """Colours of text and of what is behind it, those of labels in the window: a style sheet's too."""
    label = _sample()
    label.ensurePolished()
    ink, paper = (label.palette().color(role) for role in (label.foregroundRole(), label.backgroundRole()))
    if ink.lightness() > 128 and paper.lightness() > 128:  # what is below the label shines through
        paper = QtGui.QColor(32, 32, 32)
    return ink, paper


def load_ui(name: str) -> Any:
    """The widget that resources/ui/`name`.ui describes, with its children as attributes."""
    return FreeCADGui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui"))


class EventFilter(QtCore.QObject):
    """Sees the events of widgets before they do: a subclass has takes(event), whether nobody else gets it.
    PySide2 may hand over a deleted object that had the event's address: what is no event is not filtered."""

    def __init__(self, parent: Any, *widgets: Any):
        super().__init__(parent)
        for widget in widgets:
            widget.installEventFilter(self)

    def eventFilter(self, widget: Any, event: Any) -> bool:
        try:
            return isinstance(event, QtCore.QEvent) and self.takes(event)
        except (RuntimeError, ReferenceError):  # a view or a design is going
            return False
