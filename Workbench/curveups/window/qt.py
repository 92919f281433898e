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
           "ink_and_paper", "load_ui", "scroll_past", "translate")

RESOURCES = Path(__file__).parents[3] / "resources"


def translate(context: str, text: str, **values: Any) -> str:
    """Translate `text` into the user's language; `{name}` in it stands for values[name]."""
    translated = QtCore.QCoreApplication.translate(context, text)
    return translated.format(**values) if values else translated


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Mark a text that FreeCAD or a later `translate` translates."""
    return text


@lru_cache(maxsize=None)
def _sample() -> Any:
    """A hidden label. It stays: PySide would take later widgets at its address for it."""
    label = QtWidgets.QLabel(FreeCADGui.getMainWindow())
    label.hide()
    return label


def ink_and_paper() -> tuple[Any, Any]:
    """Colours of a label's text and of its background, with those of a style sheet."""
    label = _sample()
    label.ensurePolished()
    ink, paper = (label.palette().color(role) for role in (label.foregroundRole(), label.backgroundRole()))
    if ink.lightness() > 128 and paper.lightness() > 128:  # the label is transparent
        paper = QtGui.QColor(32, 32, 32)
    return ink, paper


class _WheelFilter(QtCore.QObject):
    """Leaves the wheel over a widget without focus to the panel around it."""

    def eventFilter(self, widget: Any, event: Any) -> bool:
        if event.type() != QtCore.QEvent.Wheel or widget.hasFocus():
            return False
        event.ignore()
        return True


@lru_cache(maxsize=None)
def _wheel_filter() -> Any:
    return _WheelFilter(FreeCADGui.getMainWindow())


def scroll_past(widget: Any) -> Any:
    """Let the wheel scroll the panel, and not edit a box, unless the user has clicked the box before."""
    if isinstance(widget, (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QSlider)):
        widget.setFocusPolicy(QtCore.Qt.StrongFocus)
        widget.installEventFilter(_wheel_filter())
    return widget


class _Loader(QtUiTools.QUiLoader):
    """Loader that makes widgets in Python. PySide may take widgets that C++ makes for deleted ones of other
    types that had their addresses."""

    def __init__(self) -> None:
        super().__init__()
        self.widgets: dict[str, Any] = {}

    def createWidget(self, kind: str, parent: Any = None, name: str = "") -> Any:
        if hasattr(QtWidgets, kind):
            widget = getattr(QtWidgets, kind)(parent)
        else:
            widget = freecad_field(kind)
            widget.setParent(parent)
        widget.setObjectName(name)
        self.widgets[name] = scroll_past(widget)
        return widget


def load_ui(name: str) -> Any:
    """Make the widget of resources/ui/`name`.ui, with its children as attributes."""
    loader = _Loader()
    form = loader.load(str(RESOURCES / "ui" / f"{name}.ui"))
    for child, widget in loader.widgets.items():
        if widget is not form:
            setattr(form, child, widget)
    return form


def freecad_field(kind: str) -> Any:
    """Make FreeCAD's own field, which reads units and expressions. PySide 6 may take it for a deleted widget
    that had its address: then make another."""
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
