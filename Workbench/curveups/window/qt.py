# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only import of PySide. FreeCAD 0.20 has Qt 5 without a QtWidgets of PySide (widgets are in its
QtGui), later ones have Qt 5 or 6 with one."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui, QtUiTools

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ("QtCore", "QtGui", "QtWidgets", "QT_TRANSLATE_NOOP", "freecad_field",
           "ink_and_paper", "load_ui", "translate")

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


class _Loader(QtUiTools.QUiLoader):
    """Makes widgets in Python. PySide may take those that C++ makes for deleted ones of other types that had
    their addresses."""

    def __init__(self) -> None:
        super().__init__()
        self.made: dict[str, Any] = {}

    def createWidget(self, kind: str, parent: Any = None, name: str = "") -> Any:
        if hasattr(QtWidgets, kind):
            widget = getattr(QtWidgets, kind)(parent)
        else:
            widget = freecad_field(kind)
            widget.setParent(parent)
        widget.setObjectName(name)
        self.made[name] = widget
        return widget


def load_ui(name: str) -> Any:
    """The widget that resources/ui/`name`.ui describes, with its children as attributes."""
    loader = _Loader()
    form = loader.load(str(RESOURCES / "ui" / f"{name}.ui"))
    for child, widget in loader.made.items():
        if widget is not form:
            setattr(form, child, widget)
    return form


def freecad_field(kind: str) -> Any:
    """FreeCAD's own field, which reads units and expressions. PySide 6 may take it for a deleted one that had
    its address: then another is made."""
    taken: list[Any] = []
    while True:
        field = FreeCADGui.UiLoader().createWidget(kind)
        try:
            field.valueChanged.connect(lambda *_: None)
            return field
        except RuntimeError:
            if len(taken) == 9:
                raise
            taken.append(field)
